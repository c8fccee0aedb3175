# A Spack recipe. As a package of a repository of your own (spack repo create), in packages/paraview_raytracedglyphs/, then
#   RTGLYPHS_SOURCE=PATH-OR-URL-OF-THE-REPOSITORY spack install paraview-raytracedglyphs
# Its dependencies are packages of Spack. It has not been installed with Spack.
import os

from spack_repo.builtin.build_systems.cmake import CMakePackage, generator

from spack.package import *


class ParaviewRaytracedglyphs(CMakePackage):
    """A ParaView plugin that draws glyphs by ray tracing, on any Vulkan device or on Mesa's lavapipe."""

    # The recipe's user says where the sources are: a clone or a URL.
    git = os.environ.get("RTGLYPHS_SOURCE", "SET-RTGLYPHS_SOURCE-TO-THE-REPOSITORY")

    license("BSD-3-Clause")

    version("main", branch="main")

    variant("qt", default=True, description="The parts for ParaView's window")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("cmake@3.21:", type="build")
    depends_on("ninja", type="build")
    depends_on("glslang", type="build")
    depends_on("spirv-tools", type=("build", "link"))
    depends_on("glm", type="build")
    depends_on("vulkan-headers@1.3.239:", type="build")
    # Loaded when the first glyph is drawn.
    depends_on("vulkan-loader", type="run")
    depends_on("paraview@5.11:+python+development_files", type=("build", "link", "run"))
    depends_on("paraview+qt", when="+qt", type=("build", "link", "run"))

    generator("ninja")

    def cmake_args(self):
        return [self.define_from_variant("RTGLYPHS_USE_QT", "qt"), self.define("BUILD_TESTING", False)]

    def setup_run_environment(self, env):
        for library in find(self.prefix, "RayTracedGlyphs.so", recursive=True):
            env.prepend_path("PV_PLUGIN_PATH", os.path.dirname(library))
