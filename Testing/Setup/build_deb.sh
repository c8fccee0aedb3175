#!/usr/bin/env bash
# Makes a Debian package of the clone's last commit for the release that it runs on, Debian 12, 13 or testing, as root or
# with sudo: installs what is missing, builds, and leaves the package in build-deb/. May be called again at any time.
# Usage: build_deb.sh     DEBFULLNAME and DEBEMAIL: whom the package names as its maintainer (default: the commit's author)
#        HOMEPAGE: the repository's address on the web; with it the package has files that name it, and sources apart from
#        what is Debian's (default: a native package)
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
clone=$(cd "$here/../.." && pwd)
[ $# = 0 ] || { sed -n '2,6s/^# //p' "$0"; exit 2; }
. /etc/os-release

echo "== packages"
"$here/install_packages.sh" build gui deb

name=paraview-raytracedglyphs
# By the commit's time, by which apt finds the later package; with its name, files have longer names than lintian allows.
commit=$(TZ=UTC git -C "$clone" log -1 --format='+git%cd' --date=format-local:%Y%m%d.%H%M)
version=$(sed -nE 's/.*project\(RayTracedGlyphs VERSION ([0-9.]+).*/\1/p' "$clone/CMakeLists.txt")$commit+${VERSION_ID:+deb}${VERSION_ID:-$VERSION_CODENAME}
revision=${HOMEPAGE:+-1} # without an address Debian calls the package native
maintainer="${DEBFULLNAME:-$(git -C "$clone" log -1 --format=%an)} <${DEBEMAIL:-$(git -C "$clone" log -1 --format=%ae)}>"
folder=$clone/build-deb
source=$folder/$name
log=$folder/build.log
echo "== build ($source, see $log)"
rm -rf "$source"
mkdir -p "$source"
git -C "$clone" archive HEAD | tar -x -C "$source"
cp -r "$source/Testing/Setup/debian" "$source/debian"
# The license's text as debian/copyright wants it: indented, and a dot where a line is empty.
sed '1,/^All rights/d; s/^/ /; s/^ $/ ./' "$source/LICENSE" | sed 1d | cat "$source/debian/copyright.in" - >"$source/debian/copyright"
# Each Debian that builds packages has g++.
packages=$("$here/install_packages.sh" --names build gui | grep -vx 'g++' | paste -s -d , | sed 's/,/, /g')
for template in control watch upstream/metadata; do
  sed -e "s|@packages@|$packages|" -e "s|@maintainer@|$maintainer|" -e "s|@homepage@|${HOMEPAGE:-}|" \
    "$source/debian/$template.in" >"$source/debian/$template"
done
if [ -n "${HOMEPAGE:-}" ]; then
  sed -i "/^Rules-Requires-Root/aHomepage: $HOMEPAGE" "$source/debian/control"
  echo '3.0 (quilt)' >"$source/debian/source/format"
  git -C "$clone" archive --prefix="$name/" HEAD | xz -T1 >"$folder/${name}_$version.orig.tar.xz"
else
  rm -r "$source/debian/watch" "$source/debian/upstream"
fi
rm -f "$source"/debian/*.in "$source"/debian/upstream/*.in
cat >"$source/debian/changelog" <<END
$name ($version$revision) $VERSION_CODENAME; urgency=medium

  * $(git -C "$clone" log -1 --format='Commit %h: %s' | fold -s -w 74 | sed 's/ *$//; 2,$s/^/    /')

 -- $maintainer  $(git -C "$clone" log -1 --format=%cD)
END
# Without a second package of the debugging symbols.
(cd "$source" && DEB_BUILD_OPTIONS="${DEB_BUILD_OPTIONS:+$DEB_BUILD_OPTIONS }noautodbgsym" dpkg-buildpackage --build=full --unsigned-source --unsigned-changes) \
  >"$log" 2>&1 || { tail -n 30 "$log" >&2; exit 1; }
rm -rf "$source"

ls "$folder/${name}_$version$revision"_*.deb
echo "== lintian"
lintian --pedantic --fail-on error,warning,info,pedantic "$folder/${name}_$version$revision"_*.changes
