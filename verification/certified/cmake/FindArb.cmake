# SPDX-License-Identifier: MIT
# Finds Arb (ball arithmetic) and its dependencies FLINT and GMP, and defines the target Arb::arb. The name of the
# library is flint-arb in Debian.
find_path(Arb_INCLUDE_DIR arb.h)
find_library(Arb_LIBRARY NAMES flint-arb arb)
find_library(Arb_FLINT_LIBRARY flint)
find_library(Arb_GMP_LIBRARY gmp)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Arb REQUIRED_VARS Arb_LIBRARY Arb_FLINT_LIBRARY Arb_GMP_LIBRARY
                                                    Arb_INCLUDE_DIR)
mark_as_advanced(Arb_INCLUDE_DIR Arb_LIBRARY Arb_FLINT_LIBRARY Arb_GMP_LIBRARY)

if(Arb_FOUND AND NOT TARGET Arb::arb)
  add_library(Arb::arb UNKNOWN IMPORTED)
  set_target_properties(
    Arb::arb PROPERTIES IMPORTED_LOCATION ${Arb_LIBRARY} INTERFACE_INCLUDE_DIRECTORIES ${Arb_INCLUDE_DIR}
                        INTERFACE_LINK_LIBRARIES "${Arb_FLINT_LIBRARY};${Arb_GMP_LIBRARY}")
endif()
