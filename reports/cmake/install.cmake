# SPDX-License-Identifier: MIT
# cmake --install: the program with its files, and the libraries for find_package(stickslip).
include(CMakePackageConfigHelpers)

set(shared_files ${CMAKE_INSTALL_DATADIR}/stickslip) # data/src/case_file.cpp looks there
set(package_files ${CMAKE_INSTALL_LIBDIR}/cmake/stickslip)

set(installed_libraries stickslip_data stickslip_files stickslip_solver stickslip_analytic)
# Shared ones are compatible as the package is: within a minor version.
foreach(library IN LISTS installed_libraries)
  string(REPLACE "stickslip_" "" name ${library})
  set_target_properties(
    ${library} PROPERTIES EXPORT_NAME ${name} VERSION ${PROJECT_VERSION}
                          SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
endforeach()
file(RELATIVE_PATH libraries ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
set_target_properties(stickslip_cli PROPERTIES INSTALL_RPATH $ORIGIN/${libraries})

install(TARGETS stickslip_cli)
install(
  TARGETS ${installed_libraries}
  EXPORT stickslip-targets
  FILE_SET HEADERS)
install(
  EXPORT stickslip-targets
  NAMESPACE stickslip::
  DESTINATION ${package_files})

configure_package_config_file(
  ${CMAKE_CURRENT_LIST_DIR}/stickslip-config.cmake.in ${CMAKE_BINARY_DIR}/stickslip-config.cmake
  INSTALL_DESTINATION ${package_files}
  PATH_VARS shared_files)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/stickslip-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/stickslip-config.cmake ${CMAKE_BINARY_DIR}/stickslip-config-version.cmake
        DESTINATION ${package_files})

install(DIRECTORY data/cases data/measurements data/paper data/reference DESTINATION ${shared_files}/data)
install(FILES data/materials.toml data/answers.schema.json DESTINATION ${shared_files}/data)
install(DIRECTORY reports/figures reports/report reports/site DESTINATION ${shared_files}/reports PATTERN readme.png EXCLUDE)
install(DIRECTORY ${CMAKE_BINARY_DIR}/share/man/ DESTINATION ${CMAKE_INSTALL_MANDIR})
install(FILES reports/cli/completion/stickslip DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES reports/cli/completion/_stickslip DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
install(FILES reports/cli/completion/stickslip.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
install(FILES LICENSE README.md CHANGELOG.md CITATION.cff CONTRIBUTING.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
# At the places to which the links of the README lead.
install(DIRECTORY reports/manual DESTINATION ${CMAKE_INSTALL_DOCDIR}/reports)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright) # where Debian looks for it
install(FILES reports/figures/readme.png DESTINATION ${CMAKE_INSTALL_DOCDIR}/reports/figures)

# cpack --preset release: a Debian package. Figures need gnuplot; users of the libraries need what their headers include.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "The stickslip authors <stickslip@localhost>")
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_BINARY_DIR})
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "gnuplot-nox, fonts-dejavu-core")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS
    "cmake, g++, pkgconf, libeigen3-dev, libarpack2-dev, libfftw3-dev, libgsl-dev, liblapacke-dev, libsuitesparse-dev, libssl-dev, zlib1g-dev, libtomlplusplus-dev, nlohmann-json3-dev, ffmpeg")
include(CPack)
