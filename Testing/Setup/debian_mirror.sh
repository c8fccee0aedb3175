# To be sourced. Finds the mirror that this machine's own apt configuration uses for its release, so that
# neighboring suites (backports, the next release's sources) can be fetched from there: no script names a host.

# Sets mirror_uri, and mirror_signed_by to a key file where the machine's entry names one.
# Returns 1 when apt has no source for the release.
find_debian_mirror() { # codename
  local entry source_file
  # CODENAME is known only after the first apt-get update, RELEASE is what the entry itself says.
  entry=$(apt-get indextargets --format '$(CODENAME) $(RELEASE) $(REPO_URI) $(SOURCESENTRY)' 'Created-By: Packages' |
    awk -v c="$1" '{ for (i = 1; i < NF - 1; ++i) if ($i == c) { print $(NF - 1), $NF; exit } }')
  mirror_uri=${entry%% *}
  mirror_uri=${mirror_uri%/}
  mirror_signed_by=
  [ -n "$mirror_uri" ] || return 1
  source_file=${entry#* }
  source_file=${source_file%:*}
  # Both formats of apt sources can name a key file; an inline key is also in apt's trusted.gpg.d on Debian.
  mirror_signed_by=$(sed -nE 's/^Signed-By: *(\/.*)/\1/p; s/.*\[.*signed-by=([^] ]+).*/\1/p' "$source_file" | head -n 1)
}

# Prints an entry in apt's deb822 format for another suite of that mirror.
debian_source_entry() { # deb|deb-src suite
  echo "Types: $1"
  echo "URIs: $mirror_uri"
  echo "Suites: $2"
  echo "Components: main"
  if [ -n "$mirror_signed_by" ]; then echo "Signed-By: $mirror_signed_by"; fi
}
