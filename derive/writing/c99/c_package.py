"""What lets others build with the headers: CMake, pkg-config, and an example."""

from __future__ import annotations

CMAKE = """\
# radartrack as headers: add_subdirectory, or install and find_package(radartrack), then
#   target_link_libraries(yours PRIVATE radartrack::radartrack)
cmake_minimum_required(VERSION 3.15)
project(radartrack VERSION {version} LANGUAGES C)

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
add_library(radartrack INTERFACE)
add_library(radartrack::radartrack ALIAS radartrack)
target_include_directories(radartrack INTERFACE
    $<BUILD_INTERFACE:${{CMAKE_CURRENT_SOURCE_DIR}}> $<INSTALL_INTERFACE:${{CMAKE_INSTALL_INCLUDEDIR}}>)
target_compile_features(radartrack INTERFACE c_std_99)
if(UNIX)
    target_link_libraries(radartrack INTERFACE m)
endif()

set(package "${{CMAKE_INSTALL_LIBDIR}}/cmake/radartrack")
install(TARGETS radartrack EXPORT radartrackTargets)
install(EXPORT radartrackTargets NAMESPACE radartrack:: FILE radartrackConfig.cmake DESTINATION "${{package}}")
write_basic_package_version_file(radartrackConfigVersion.cmake COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES "${{CMAKE_CURRENT_BINARY_DIR}}/radartrackConfigVersion.cmake" DESTINATION "${{package}}")
file(GLOB headers "${{CMAKE_CURRENT_SOURCE_DIR}}/radartrack*.h")
install(FILES ${{headers}} DESTINATION "${{CMAKE_INSTALL_INCLUDEDIR}}")
file(RELATIVE_PATH up "/${{CMAKE_INSTALL_LIBDIR}}/pkgconfig" "/")
file(READ "${{CMAKE_CURRENT_SOURCE_DIR}}/radartrack.pc" pc)
set(include "\\${{pcfiledir}}/${{up}}${{CMAKE_INSTALL_INCLUDEDIR}}")
string(REPLACE "=\\${{pcfiledir}}" "=${{include}}" pc "${{pc}}")
file(WRITE "${{CMAKE_CURRENT_BINARY_DIR}}/radartrack.pc" "${{pc}}")
install(FILES "${{CMAKE_CURRENT_BINARY_DIR}}/radartrack.pc" DESTINATION "${{CMAKE_INSTALL_LIBDIR}}/pkgconfig")
"""
PKG_CONFIG = """\
includedir=${{pcfiledir}}

Name: radartrack
Description: Derived formulas of radar tracking as C99 headers
Version: {version}
Cflags: -I${{includedir}}
Libs: -lm
"""
EXAMPLE = """\
/* Two plots of a radar in Cartesian coordinates: cc -std=c99 example.c -lm && ./a.out */
#include <stdio.h>

#include "radartrack.h"

int main(void)
{
    const double ranges[2] = {40e3, 80e3}, azimuths[2] = {0.5, 2.0};
    int i;
    for (i = 0; i < 2; ++i) {
        double mean[2], covariance[4];
        radartrack_convert_polar_unbiased(ranges[i], azimuths[i], 50.0, 0.02, 0.0, mean, covariance);
        printf("x %10.3f m, y %10.3f m, variances %.1f and %.1f m^2, covariance %.1f m^2\\n",
               mean[0], mean[1], covariance[0], covariance[3], covariance[1]);
    }
    return 0;
}
"""
EXAMPLE_USES = "radartrack_convert_polar_unbiased"


def package(version: str, functions: frozenset[str]) -> dict[str, str]:
    """The files beside the headers; the example where what it calls is there.

    Args:
        version: of radartrack.
        functions: the names of all that is defined.
    """
    found = {"CMakeLists.txt": CMAKE.format(version=version), "radartrack.pc": PKG_CONFIG.format(version=version)}
    return found | ({"example.c": EXAMPLE} if EXAMPLE_USES in functions else {})
