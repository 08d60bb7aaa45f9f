# SPDX-License-Identifier: MIT
# cmake -D PROGRAM=... -D SOURCE_DIR=... -D BUILD_DIR=... -D GENERATOR=... -D COMPILER=... -D FLAGS=... -D TYPE=... -D UNITY=... -D BATCH=...
# -P rebuild_test.cmake: builds the command line a second time, from a copy of the sources in a folder of another path and
# another length, and asks both programs for the same outputs, which have to be the same bytes.
set(scratch ${BUILD_DIR}/rebuild-test)
set(copy ${scratch}/elsewhere/a-copy-of-the-sources)
file(REMOVE_RECURSE ${scratch})
foreach(item IN ITEMS CMakeLists.txt LICENSE README.md CHANGELOG.md data solver analytic verification reports)
  file(COPY ${SOURCE_DIR}/${item} DESTINATION ${copy})
endforeach()

# run(COMMAND...): in an empty environment but for PATH; no cache of a compiler stands in for the second build.
function(run)
  execute_process(
    COMMAND env -i PATH=/usr/bin:/bin CCACHE_DISABLE=1 ${ARGN}
    OUTPUT_QUIET
    COMMAND_ERROR_IS_FATAL ANY)
endfunction()

run(${CMAKE_COMMAND} -S ${copy} -B ${scratch}/build -G ${GENERATOR} -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_CXX_FLAGS=${FLAGS}
    -D CMAKE_BUILD_TYPE=${TYPE} -D CMAKE_UNITY_BUILD=${UNITY} -D CMAKE_UNITY_BUILD_BATCH_SIZE=${BATCH} -D STICKSLIP_BUILD_TESTS=OFF)
run(${CMAKE_COMMAND} --build ${scratch}/build --target stickslip_cli)

set(commands
    "report --only fig1,fig2,fig7,fig9 --output report"
    "respond paper --hz 25 --amplitude 1e-3 --duration 0.3 --output finite-elements.csv --events finite-elements-events.csv"
    "respond damped --method event-driven --hz 25 --duration 0.2 --output event-driven.csv --events event-driven-events.csv"
    "respond paper --method closed-form --duration 0.5 --output closed-form.csv"
    "map paper --x frequency=1:120:60 --y amplitude=5e-5:1e-3:10 --output map.csv --figure map.svg"
    "map damped --method fe --x frequency=20:30:6 --y friction=0.2:0.8:4 --duration 0.5 --output finite-elements-map.csv"
    "criterion paper"
    "criterion steel-strip --hz 30 --json"
    "design steel-strip --band 24:26 --length 0.25:0.35 --force 10:40"
    "modes paper --state slip --count 5 --json")
foreach(build IN ITEMS first second)
  set(program ${PROGRAM})
  if(build STREQUAL second)
    set(program ${scratch}/build/bin/stickslip)
  endif()
  set(${build}_program ${program})
  execute_process(COMMAND ${program} --version OUTPUT_VARIABLE ${build}_version OUTPUT_STRIP_TRAILING_WHITESPACE
                  COMMAND_ERROR_IS_FATAL ANY)
  file(MAKE_DIRECTORY ${scratch}/${build})
  set(number 0)
  foreach(command IN LISTS commands)
    math(EXPR number "${number} + 1")
    separate_arguments(arguments UNIX_COMMAND "${command}")
    execute_process(
      COMMAND ${program} ${arguments} --quiet
      WORKING_DIRECTORY ${scratch}/${build}
      OUTPUT_FILE ${scratch}/${build}/stdout-${number}
      ERROR_FILE ${scratch}/${build}/stderr-${number}
      COMMAND_ERROR_IS_FATAL ANY)
  endforeach()
  file(GLOB_RECURSE ${build}_files RELATIVE ${scratch}/${build} ${scratch}/${build}/*)
endforeach()

if(NOT first_files STREQUAL second_files)
  message(FATAL_ERROR "the first build wrote ${first_files}, but the second ${second_files}")
endif()
set(different)
foreach(file IN LISTS first_files)
  foreach(build IN ITEMS first second)
    file(SHA256 ${scratch}/${build}/${file} ${build})
    if(file MATCHES "[.]csv$|^stdout") # which say by which program they are; the copy knows no commit
      file(READ ${scratch}/${build}/${file} ${build})
      string(REPLACE "${${build}_version}" "stickslip" ${build} "${${build}}")
      string(REPLACE "${${build}_program}" "stickslip" ${build} "${${build}}")
    endif()
  endforeach()
  if(NOT first STREQUAL second)
    list(APPEND different ${file})
  endif()
endforeach()
if(different)
  message(FATAL_ERROR "in ${scratch}/first and second these files differ: ${different}")
endif()
list(LENGTH first_files count)
message(STATUS "${count} files are the same")
file(REMOVE_RECURSE ${scratch})
