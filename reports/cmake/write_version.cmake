# SPDX-License-Identifier: MIT
# Run at every build, so that the commit follows HEAD: cmake -D SOURCE_DIR=... -D STICKSLIP_VERSION=... -D TEMPLATE=...
# -D HEADER=... -P write_version.cmake. The header is touched only when its text changes.
set(STICKSLIP_COMMIT "unknown")
find_program(GIT git)
if(GIT)
  # Asked of this tree alone, which belongs to another user where it is mounted into a container. A repository above it is not looked at.
  execute_process(
    COMMAND ${GIT} --git-dir=.git --work-tree=. describe --always --dirty --abbrev=12 --exclude=*
    WORKING_DIRECTORY ${SOURCE_DIR}
    RESULT_VARIABLE result
    OUTPUT_VARIABLE described
    OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(result EQUAL 0)
    set(STICKSLIP_COMMIT "${described}")
  endif()
endif()
configure_file("${TEMPLATE}" "${HEADER}" @ONLY)
