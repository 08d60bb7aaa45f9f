# cmake -D CTEST=... -D BINARY_DIR=... -D RESULTS=... -P run_suite.cmake: runs all tests but the slow ones with their
# results as XML in a folder that holds nothing else. Where one fails there is no stamp, and the next build tries again.
file(REMOVE_RECURSE "${RESULTS}")
file(REMOVE "${BINARY_DIR}/test-results.stamp")
cmake_host_system_information(RESULT cores QUERY NUMBER_OF_LOGICAL_CORES)
execute_process(
  COMMAND "${CTEST}" --test-dir "${BINARY_DIR}" --label-exclude "^slow$" --no-tests=error --parallel ${cores}
          --output-on-failure
  RESULT_VARIABLE status)
if(status EQUAL 0)
  file(TOUCH "${BINARY_DIR}/test-results.stamp")
endif()
