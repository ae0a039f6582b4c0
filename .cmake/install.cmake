# cmake --install: program, cases with their meshes, documents, man page. cpack: a Debian package of the same.
include(GNUInstallDirs)
# Documents, cases and meshes lie to each other as in the source, so that their links and paths hold.
set(shared ${CMAKE_INSTALL_DATADIR}/birdstrike)
install(DIRECTORY prm meshes DESTINATION ${shared}
  PATTERN run.sh EXCLUDE PATTERN site EXCLUDE PATTERN build.sh EXCLUDE PATTERN entries.py EXCLUDE PATTERN __pycache__ EXCLUDE)
install(FILES README.md CHANGELOG.md LICENSE DESTINATION ${shared})
install(FILES source/README.md source/how-to-add.md DESTINATION ${shared}/source)
install(DIRECTORY tests DESTINATION ${shared} FILES_MATCHING PATTERN "*.md" PATTERN "*.svg" PATTERN data EXCLUDE PATTERN unit EXCLUDE)
install(FILES README.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES .cmake/birdstrike.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES .cmake/completions.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME birdstrike)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME birdstrike)
set(CPACK_PACKAGE_CONTACT "the birdstrike developers")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON) # dpkg-shlibdeps names the packages of the libraries
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "gnuplot-nox, libopenblas0-serial, python3-numpy, python3-h5py")
include(CPack)
