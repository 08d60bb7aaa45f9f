# Run when one of the libraries changes: cmake -D LIBRARIES=... -D VERSIONS=... -D HEADER=... -P write_fingerprint.cmake.
# The header names the code of the studies by the hash of the libraries that hold it.
set(hashes "${VERSIONS}")
foreach(library IN LISTS LIBRARIES)
  file(SHA256 "${library}" hash)
  string(APPEND hashes "${hash}")
endforeach()
string(SHA256 fingerprint "${hashes}")
file(WRITE "${HEADER}" "#pragma once\n\nnamespace stickslip::report {\n\n\
/// Changes with the code of the studies and of all that they use.\n\
inline constexpr char study_code[] = \"${fingerprint}\";\n\n}  // namespace stickslip::report\n")
