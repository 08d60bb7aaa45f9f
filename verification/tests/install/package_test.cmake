# SPDX-License-Identifier: MIT
# cmake -D CPACK=... -D BUILD_DIR=... -P package_test.cmake: makes the Debian package, unpacks it elsewhere, and asks the program there
# for its files.
set(scratch ${BUILD_DIR}/package-test)
set(root ${scratch}/root)
file(REMOVE_RECURSE ${scratch})

# run(<variable for standard output> COMMAND...)
function(run output)
  execute_process(
    COMMAND ${ARGN}
    OUTPUT_VARIABLE text
    COMMAND_ERROR_IS_FATAL ANY)
  set(${output} "${text}" PARENT_SCOPE)
endfunction()

run(ignored ${CPACK} --config ${BUILD_DIR}/CPackConfig.cmake -G DEB -B ${scratch})
file(GLOB package ${scratch}/stickslip_*.deb)
run(ignored dpkg-deb --extract ${package} ${root})
run(dependencies dpkg-deb --field ${package} Depends)
if(NOT dependencies MATCHES "libc6 .*libgsl")
  message(FATAL_ERROR "the package depends on '${dependencies}', but must depend on the libraries that the program uses")
endif()
run(cases env -i ${root}/usr/bin/stickslip cases --json)
string(JSON file GET "${cases}" cases 0 file)
if(NOT file MATCHES "^${root}/usr/share/stickslip/data/cases/")
  message(FATAL_ERROR "the first case is read from '${file}', but must be read from the package")
endif()
run(ignored env -i ${root}/usr/bin/stickslip criterion steel-strip)
file(REMOVE_RECURSE ${scratch})
