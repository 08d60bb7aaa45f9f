# SPDX-License-Identifier: MIT
# Run at every build, so that the commit follows HEAD: cmake -D SOURCE_DIR=... -D STICKSLIP_VERSION=... -D TEMPLATE=...
# -D HEADER=... -P write_version.cmake. The header is touched only when its text changes.
set(STICKSLIP_COMMIT "unknown")
find_program(GIT git)
if(GIT AND EXISTS "${SOURCE_DIR}/.git")
  # safe.directory: a checkout mounted into a container belongs to another user there.
  execute_process(
    COMMAND ${GIT} -c safe.directory=${SOURCE_DIR} describe --always --dirty --abbrev=12 --exclude=*
    WORKING_DIRECTORY ${SOURCE_DIR}
    RESULT_VARIABLE result
    OUTPUT_VARIABLE described
    OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(result EQUAL 0)
    set(STICKSLIP_COMMIT "${described}")
  endif()
endif()
configure_file("${TEMPLATE}" "${HEADER}" @ONLY)
