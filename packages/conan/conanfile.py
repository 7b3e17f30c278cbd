"""A Conan 2 recipe of the tree that it lies in: conan create packages/conan"""

import os

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy


class Foredraw(ConanFile):
    name = "foredraw"
    version = "0.1.0"
    description = "Makes real-time scenes cheaper to draw before they are drawn"
    license = "MIT"
    package_type = "library"
    settings = "os", "compiler", "build_type", "arch"
    options = {"plugins": ["ANY"]}
    default_options = {"plugins": ""}  # names with semicolons between; empty: all whose packages are there

    def export_sources(self):
        root = os.path.join(self.recipe_folder, "..", "..")
        for pattern in ["CMakeLists.txt", "LICENSE*", "framework/*", "plugins/*", "evaluators/*", "hosts/*"]:
            copy(self, pattern, root, self.export_sources_folder)

    def requirements(self):
        for package in [
            "cli11/[>=2.1]",
            "draco/[>=1.5]",
            "fmt/[>=9]",
            "glm/[>=0.9.9]",
            "highway/[>=1.0]",
            "libpng/[>=1.6]",
            "meshoptimizer/[>=0.18]",
            "nlohmann_json/[>=3.11]",
            "onetbb/[>=2021.8]",
            "tomlplusplus/[>=3.3]",
            "xxhash/[>=0.8]",
            "zlib/[>=1.2]",
        ]:
            self.requires(package)

    def layout(self):
        cmake_layout(self)

    def generate(self):
        CMakeDeps(self).generate()
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["FOREDRAW_BUILD_TESTS"] = False
        toolchain.cache_variables["FOREDRAW_PLUGINS"] = str(self.options.plugins)
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()

    def package_info(self):
        self.cpp_info.set_property("cmake_find_mode", "none")  # its own package for CMake is installed
        self.cpp_info.builddirs.append(os.path.join("lib", "cmake", "foredraw"))
