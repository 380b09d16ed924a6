# Installs the build tree BUILD below WORK, moves the result elsewhere (an install tree must not know its place), and
# builds and runs the consumer against it: first by find_package, then by pkg-config. COMPONENTS are those that have to
# be there (io;tbb;mpi); the others are tried where they are.
cmake_minimum_required(VERSION 3.22)

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# Left-overs of an earlier run would hide a file that is no longer installed.
file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}")

set(config "")
if(CONFIG)
  set(config --config "${CONFIG}")
endif()
run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${WORK}/installed" ${config})
file(RENAME "${WORK}/installed" "${WORK}/moved")

# graze_ROOT is searched before every other place, so a Graze that is installed on this machine is not taken.
run("${CMAKE_COMMAND}" -S "${SOURCE}" -B "${WORK}/cmake" -G "${GENERATOR}" "-DCMAKE_CXX_COMPILER=${CXX}" "-DCMAKE_C_COMPILER=${CC}"
    "-DCMAKE_BUILD_TYPE=${CONFIG}" "-Dgraze_ROOT=${WORK}/moved")
run("${CMAKE_COMMAND}" --build "${WORK}/cmake" ${config})
run("${WORK}/cmake/consumer")
run("${WORK}/cmake/two_boxes")
# What a program does not reach it does not carry, without a flag of its own: 5.9 MB once, 1.2 since functions have
# sections. Sanitizers bring a library of their own, and debugging keeps what an optimiser would drop.
find_program(strip strip)
if(CONFIG STREQUAL "Release" AND strip AND CMAKE_HOST_SYSTEM_NAME STREQUAL "Linux")
  run("${strip}" -o "${WORK}/two_boxes_stripped" "${WORK}/cmake/two_boxes")
  file(SIZE "${WORK}/two_boxes_stripped" size)
  if(size GREATER 1500000)
    message(FATAL_ERROR "a program that asks for the distance of two boxes has ${size} bytes; expected at most 1,500,000")
  endif()
endif()
run("${WORK}/cmake/consumer_c")
# As one rank, without mpirun; in a container the only user may be root.
set(ENV{OMPI_ALLOW_RUN_AS_ROOT} 1)
set(ENV{OMPI_ALLOW_RUN_AS_ROOT_CONFIRM} 1)
foreach(component IN ITEMS shared c_shared io tbb mpi)
  if(EXISTS "${WORK}/cmake/consumer_${component}")
    run("${WORK}/cmake/consumer_${component}")
  elseif(component IN_LIST COMPONENTS)
    message(FATAL_ERROR "graze::${component} was built and installed, and find_package does not give it")
  endif()
endforeach()

find_program(make NAMES gmake make REQUIRED)
set(ENV{PKG_CONFIG_PATH} "${WORK}/moved/${LIBDIR}/pkgconfig")
set(ENV{LD_LIBRARY_PATH} "${WORK}/moved/${LIBDIR}") # for shared builds
run("${make}" -C "${SOURCE}" "CXX=${CXX}" "CC=${CC}" "OUT=${WORK}/consumer_pkgconfig")
run("${WORK}/consumer_pkgconfig")
run("${WORK}/consumer_pkgconfig_c")

if(EXISTS "${WORK}/moved/bin/graze")
  run("${WORK}/moved/bin/graze" --help)
endif()
