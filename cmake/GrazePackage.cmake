# Debian packages, by `make package`: libgraze<version> for programs that run, libgraze-dev for those that are built, and
# graze, the program; python3-graze where the Python package is built. A package of another binding is one more component
# here, with its install rules beside the others.
set(graze_soversion "${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME graze)
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_PACKAGE_CONTACT "The maintainers of Graze <graze@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_PACKAGING_INSTALL_PREFIX "${CMAKE_INSTALL_PREFIX}")
set(CPACK_STRIP_FILES ON)

set(CPACK_COMPONENTS_ALL library development program)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON) # what programs and libraries are linked with
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS OFF)

set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME "libgraze${graze_soversion}")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
set(CPACK_COMPONENT_LIBRARY_DESCRIPTION "Collision detection: the shared library\n\
Do these things touch, where, how deep, how far apart and when: for C++20 and C, in float and double.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libgraze-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libgraze${graze_soversion} (= ${PROJECT_VERSION})")
# Behind the components io, tbb and mpi of find_package(graze).
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS "libtinygltf-dev, libfmt-dev, libtbb-dev")
if(TARGET graze_mpi)
  string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS ", libopenmpi-dev, libtrilinos-zoltan-dev")
endif()
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "Collision detection: headers and libraries to build with\n\
For C++20 (graze/graze.hpp) and C99 (graze/graze.h), by CMake or pkg-config.")

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME graze)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "Collision detection: the program\n\
Collides, casts, simulates and explains scenes in glTF, OBJ, STL and PLY.")

if(TARGET graze_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-graze)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  # The module is for one minor version of the interpreter: its file's name says so.
  get_directory_property(Python_VERSION_MINOR DIRECTORY "${PROJECT_SOURCE_DIR}/bindings/python" DEFINITION
                                                        Python_VERSION_MINOR)
  math(EXPR graze_next_python "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
      "python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${graze_next_python}), python3-numpy")
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION "Collision detection: the Python package\n\
Shapes, queries, worlds and simulation for Python, over NumPy's arrays: import graze.")
endif()

# The licence where Debian looks for it.
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER "${component}" upper)
  install(FILES "${PROJECT_SOURCE_DIR}/LICENSE"
          DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME}"
          COMPONENT ${component} RENAME copyright)
endforeach()

include(CPack)
