# SPDX-License-Identifier: MIT
# cmake -D BUILD_DIR=... -D SOURCE_DIR=... -D GENERATOR=... -D COMPILER=... -D FLAGS=... -P install_test.cmake: installs into a
# temporary prefix, moves that, asks the program there where its files are, and lets a project of somebody else find, link and
# run the libraries, whose numbers have to be those of the program to the last digit.
set(scratch ${BUILD_DIR}/install-test)
set(prefix ${scratch}/moved)
set(consumer ${SOURCE_DIR}/verification/tests/install/consumer)
set(my_beam ${consumer}/my-beam.toml)
file(REMOVE_RECURSE ${scratch})

# run(<variable for standard output> COMMAND...): in an empty environment but for PATH.
function(run output)
  execute_process(
    COMMAND env -i PATH=/usr/bin:/bin ${ARGN}
    OUTPUT_VARIABLE text
    COMMAND_ERROR_IS_FATAL ANY)
  set(${output} "${text}" PARENT_SCOPE)
endfunction()

# expect_equal(WHAT EXPECTED FOUND)
function(expect_equal what expected found)
  if(expected STREQUAL "" OR NOT found STREQUAL expected)
    message(FATAL_ERROR "${what} is '${found}', but must be '${expected}'")
  endif()
endfunction()

# only_match(<variable> PATTERN TEXT): what the parentheses of the pattern match.
function(only_match variable pattern text)
  if(NOT text MATCHES "${pattern}")
    message(FATAL_ERROR "'${pattern}' is not found in:\n${text}")
  endif()
  set(${variable} "${CMAKE_MATCH_1}" PARENT_SCOPE)
endfunction()

run(ignored ${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${scratch}/installed)
file(RENAME ${scratch}/installed ${prefix})
set(stickslip ${prefix}/bin/stickslip)

# The program, from its new place.
run(cases ${stickslip} cases --json)
string(JSON count LENGTH "${cases}" cases)
math(EXPR last "${count} - 1")
foreach(i RANGE ${last})
  string(JSON name GET "${cases}" cases ${i} name)
  string(JSON file GET "${cases}" cases ${i} file)
  expect_equal("the file of the case ${name}" ${prefix}/share/stickslip/data/cases/${name}.toml "${file}")
endforeach()
run(data_set ${stickslip} reference show stick-frequencies)
only_match(data_file "rows, ([^\n]*)" "${data_set}")
expect_equal("the file of the data set" ${prefix}/share/stickslip/data/reference/frequencies/stick.csv "${data_file}")
file(MAKE_DIRECTORY ${prefix}/share/stickslip/reports/elsewhere)
file(RENAME ${prefix}/share/stickslip/reports/report ${prefix}/share/stickslip/reports/elsewhere/report)
execute_process(
  COMMAND ${stickslip} map paper --x frequency=10:20:2 --y amplitude=1e-4:2e-4:2 --output ${scratch}/map.csv --figure ${scratch}/map.svg
  ERROR_VARIABLE refusal
  RESULT_VARIABLE status)
expect_equal("the exit status without templates" 2 ${status})
only_match(templates "is ([^ ]*), but" "${refusal}")
expect_equal("the folder of templates" ${prefix}/share/stickslip/reports "${templates}")

# Shared libraries have a version, so that an incompatible one is not loaded in their place.
file(GLOB_RECURSE shared_libraries ${prefix}/lib*/libstickslip_*.so)
foreach(library IN LISTS shared_libraries)
  if(NOT IS_SYMLINK ${library})
    message(FATAL_ERROR "${library} has no version")
  endif()
endforeach()

# The libraries, from their new place.
run(ignored ${CMAKE_COMMAND} -S ${consumer} -B ${scratch}/build -G ${GENERATOR} -D CMAKE_PREFIX_PATH=${prefix}
    -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_CXX_FLAGS=${FLAGS})
run(ignored ${CMAKE_COMMAND} --build ${scratch}/build)
file(READ ${scratch}/build/CMakeCache.txt cache)
only_match(package "stickslip_DIR:PATH=([^\n]*)" "${cache}")
if(NOT package MATCHES "^${prefix}/")
  message(FATAL_ERROR "the package is that of ${package}, but must be that of ${prefix}")
endif()

run(numbers ${scratch}/build/consumer ${my_beam})
run(criterion ${stickslip} criterion ${my_beam} --json)
run(history ${stickslip} respond ${my_beam} --method fe --duration 1e-3)
only_match(theirs "critical amplitude / m: ([^\n]*)" "${numbers}")
only_match(ours "\"critical_amplitude_m\": ([^,\n]*)" "${criterion}")
expect_equal("the critical amplitude" "${ours}" "${theirs}")
only_match(theirs "midspan / m: ([^\n]*)" "${numbers}")
only_match(ours "\n0.001,[^,]*,[^,]*,([^,]*)," "${history}")
expect_equal("the displacement at midspan" "${ours}" "${theirs}")
only_match(theirs "friction force / N: ([^\n]*)" "${numbers}")
only_match(ours "\n0.001,[^,]*,[^,]*,[^,]*,[^,]*,([^,]*)," "${history}")
expect_equal("the friction force" "${ours}" "${theirs}")

file(REMOVE_RECURSE ${scratch})
