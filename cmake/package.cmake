# SPDX-License-Identifier: BSD-3-Clause
# What is installed, and the Debian package. Two components: runtime (BSD: compiled models loaded and integrated) and the
# rest, which links GiNaC.
include(CMakePackageConfigHelpers)

set(KANEC_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/kanec)

set_target_properties(kanec_library PROPERTIES INSTALL_RPATH "$ORIGIN")  # the runtime beside it, in any prefix

set(KANEC_RUNTIME_HEADERS abi error export model batch motion runtime)
set(KANEC_HEADERS value scene kanec)
foreach(header ${KANEC_RUNTIME_HEADERS})
  if(EXISTS ${PROJECT_SOURCE_DIR}/runtime/front/kanec/${header}.hpp)
    install(FILES runtime/front/kanec/${header}.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/kanec COMPONENT runtime)
  endif()
endforeach()
install(FILES runtime/abi/abi.h runtime/base/error.hpp runtime/lanes/rk4_step.hpp
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/kanec COMPONENT runtime)
foreach(header ${KANEC_HEADERS})
  install(FILES runtime/front/kanec/${header}.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/kanec COMPONENT generator)
endforeach()

install(TARGETS kanec_runtime_library EXPORT kanecRuntimeTargets LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT runtime)
install(TARGETS kanec_library kanec EXPORT kanecTargets
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT generator)
set_target_properties(kanec PROPERTIES EXPORT_NAME tool)
install(EXPORT kanecRuntimeTargets NAMESPACE kanec:: DESTINATION ${KANEC_CMAKE_DIR} COMPONENT runtime)
install(EXPORT kanecTargets NAMESPACE kanec:: DESTINATION ${KANEC_CMAKE_DIR} COMPONENT generator)

configure_package_config_file(cmake/kanecConfig.cmake.in ${PROJECT_BINARY_DIR}/cmake/kanecConfig.cmake
  INSTALL_DESTINATION ${KANEC_CMAKE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/cmake/kanecConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/cmake/kanecConfig.cmake ${PROJECT_BINARY_DIR}/cmake/kanecConfigVersion.cmake
  DESTINATION ${KANEC_CMAKE_DIR} COMPONENT runtime)
install(FILES cmake/kanecGenerate.cmake DESTINATION ${KANEC_CMAKE_DIR} COMPONENT generator)

file(RELATIVE_PATH KANEC_PREFIX_FROM_PC ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})

# kanec_pkg_config(FILE DESCRIPTION LICENCE LIBRARY REQUIRES)
function(kanec_pkg_config file description library requires)
  set(KANEC_PC_NAME ${file})
  set(KANEC_PC_DESCRIPTION ${description})
  set(KANEC_PC_LIBRARY ${library})
  set(KANEC_PC_REQUIRES ${requires})
  configure_file(cmake/kanec.pc.in ${PROJECT_BINARY_DIR}/cmake/${file}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/cmake/${file}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT runtime)
endfunction()
kanec_pkg_config(kanec-runtime "Compiled models of kanec: loaded, evaluated, integrated" kanec_runtime "")
kanec_pkg_config(kanec "A Kane compiler: scenes of rigid bodies to solvers" kanec kanec-runtime)

install(FILES docs/kanec.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT generator)
install(FILES cmake/completion.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME kanec COMPONENT generator)
install(FILES README.md DESIGN.md CONVENTIONS.md LICENSES.md LICENSE.BSD-3-Clause LICENSE.GPL-2.0-or-later
  DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT generator)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT generator PATTERN kanec.1 EXCLUDE)
install(DIRECTORY models DESTINATION ${CMAKE_INSTALL_DATADIR}/kanec COMPONENT generator)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME kanec)
set(CPACK_PACKAGE_CONTACT "kanec <kanec@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Kane compiler: a tree of rigid bodies to a flat C++ solver")
set(CPACK_PACKAGE_DESCRIPTION "Equations of motion derived symbolically by Kane's method and emitted as C++ or C.
 The tool, libraries for C++ and a module for Python.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/runtime/front)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "g++ | clang")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "python3-numpy, gnuplot-nox")
set(CPACK_STRIP_FILES ON)
include(CPack)
