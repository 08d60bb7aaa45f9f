# SPDX-License-Identifier: MIT
# cmake -D CTEST=... -D BINARY_DIR=... -D RESULTS=... -D LABEL=... -P run_label.cmake: runs the tests of a label, with their
# results as XML in a folder that holds no older ones of that label. Where one fails there is no stamp, and the next build
# tries again.
file(GLOB old "${RESULTS}/${LABEL}.*")
if(old)
  file(REMOVE_RECURSE ${old})
endif()
cmake_host_system_information(RESULT cores QUERY NUMBER_OF_LOGICAL_CORES)
execute_process(
  COMMAND "${CTEST}" --test-dir "${BINARY_DIR}" --label-regex "^${LABEL}$" --no-tests=error --parallel ${cores}
          --output-on-failure
  RESULT_VARIABLE status)
if(status EQUAL 0)
  file(TOUCH "${RESULTS}/${LABEL}.stamp")
else()
  message("Tests of the label ${LABEL} have failed")
endif()
