# The install tree: libraries, headers, the package for find_package(graze) and those for pkg-config. Every path in it is
# relative, so that the tree can be moved after the installation. Its components are those of cmake/GrazePackage.cmake:
# `library` (libgraze.so as programs need it), `development` and `program`, and `python` (bindings/python); and
# `program_mpi`, which is in no package.
include(CMakePackageConfigHelpers)

set(graze_cmake_dir "${CMAKE_INSTALL_LIBDIR}/cmake/graze")

# graze_install(<target> <export>): a library and what names it to CMake.
function(graze_install target export)
  install(TARGETS ${target} EXPORT ${export}
          ARCHIVE COMPONENT development
          LIBRARY COMPONENT library NAMELINK_COMPONENT development
          RUNTIME COMPONENT library)
endfunction()

graze_install(graze grazeTargets)
if(TARGET graze_shared)
  graze_install(graze_shared grazeTargets)
endif()
install(DIRECTORY "${PROJECT_SOURCE_DIR}/include/graze" TYPE INCLUDE COMPONENT development
        FILES_MATCHING PATTERN "*.hpp" PATTERN "*.h"
        PATTERN "io" EXCLUDE PATTERN "mpi" EXCLUDE PATTERN "tbb_executor.hpp" EXCLUDE)
install(EXPORT grazeTargets NAMESPACE graze:: DESTINATION "${graze_cmake_dir}" COMPONENT development)
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" "${PROJECT_SOURCE_DIR}/CHANGELOG.md" TYPE DOC COMPONENT development)

# Components of their own, since whoever uses only the core must not need the packages behind these.
if(TARGET graze_io)
  graze_install(graze_io grazeIoTargets)
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/include/graze/io" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/graze"
          COMPONENT development)
  install(EXPORT grazeIoTargets NAMESPACE graze:: DESTINATION "${graze_cmake_dir}" COMPONENT development)
endif()
if(TARGET graze_tbb)
  graze_install(graze_tbb grazeTbbTargets)
  install(FILES "${PROJECT_SOURCE_DIR}/include/graze/tbb_executor.hpp" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/graze"
          COMPONENT development)
  install(EXPORT grazeTbbTargets NAMESPACE graze:: DESTINATION "${graze_cmake_dir}" COMPONENT development)
endif()
if(TARGET graze_mpi)
  graze_install(graze_mpi grazeMpiTargets)
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/include/graze/mpi" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/graze"
          COMPONENT development)
  install(EXPORT grazeMpiTargets NAMESPACE graze:: DESTINATION "${graze_cmake_dir}" COMPONENT development)
endif()
if(TARGET graze_mpi_cli) # not a part of the program's package, which needs no MPI
  set_target_properties(graze_mpi_cli PROPERTIES INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")
  install(TARGETS graze_mpi_cli COMPONENT program_mpi)
endif()
if(TARGET graze_cli)
  set_target_properties(graze_cli PROPERTIES INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}") # for shared builds
  install(TARGETS graze_cli COMPONENT program)
  # Where `make lab` built it: `graze view` finds it there.
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/apps/lab/dist/" DESTINATION "${CMAKE_INSTALL_DATADIR}/graze/lab"
          COMPONENT program OPTIONAL)
endif()

# What an installation needs, and nothing else that the build tree may hold.
add_custom_target(graze_installed)
foreach(target IN ITEMS graze graze_shared graze_io graze_tbb graze_mpi graze_cli graze_mpi_cli)
  if(TARGET ${target})
    add_dependencies(graze_installed ${target})
  endif()
endforeach()

configure_package_config_file(
  "${PROJECT_SOURCE_DIR}/cmake/grazeConfig.cmake.in" "${PROJECT_BINARY_DIR}/grazeConfig.cmake"
  INSTALL_DESTINATION "${graze_cmake_dir}")
# Before 1.0 every minor version may break its users.
write_basic_package_version_file("${PROJECT_BINARY_DIR}/grazeConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/grazeConfig.cmake" "${PROJECT_BINARY_DIR}/grazeConfigVersion.cmake"
        DESTINATION "${graze_cmake_dir}" COMPONENT development)

file(RELATIVE_PATH graze_pc_to_prefix "${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig" "${CMAKE_INSTALL_PREFIX}")
list(JOIN graze_keep_reached " " graze_pc_link_options)
# Two packages, since a compiler of C refuses the standard that C++ has to be told.
configure_file("${PROJECT_SOURCE_DIR}/cmake/graze.pc.in" "${PROJECT_BINARY_DIR}/graze.pc" @ONLY)
configure_file("${PROJECT_SOURCE_DIR}/cmake/graze-c.pc.in" "${PROJECT_BINARY_DIR}/graze-c.pc" @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/graze.pc" "${PROJECT_BINARY_DIR}/graze-c.pc"
        DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig" COMPONENT development)
