# The Debian package: `cmake --preset package`, `cmake --build --preset package`, `cpack --preset package`, or
# scripts/package, which also lints it. For builds whose prefix is /usr.

# package_gzip(SOURCE NAME DESTINATION): installs SOURCE as NAME.gz, without its time, so that every build has the same.
function(package_gzip source name destination)
    set(compressed ${CMAKE_CURRENT_BINARY_DIR}/packaging/${name}.gz)
    file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/packaging)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source})
    execute_process(COMMAND gzip -9nc ${source} OUTPUT_FILE ${compressed} COMMAND_ERROR_IS_FATAL ANY)
    install(FILES ${compressed} DESTINATION ${destination})
endfunction()

package_gzip(${PROJECT_SOURCE_DIR}/packaging/metamer.1 metamer.1 ${CMAKE_INSTALL_MANDIR}/man1)
package_gzip(${PROJECT_SOURCE_DIR}/packaging/changelog changelog ${CMAKE_INSTALL_DOCDIR})
install(FILES packaging/copyright LICENSE-DATA.md TYPE DOC)
install(FILES packaging/metamer.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME metamer)
# The pages for those who run an exhibit, with their pictures. They link to each other, to screens/ and to ../config.
install(FILES docs/curators.md docs/technicians.md docs/service.md DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs)
install(FILES docs/screens/start.png docs/screens/booth.png DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs/screens)
file(CREATE_LINK ../../metamer/config ${CMAKE_CURRENT_BINARY_DIR}/packaging/config SYMBOLIC)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/packaging/config TYPE DOC)
# /usr/lib, whatever the libraries' folder is called.
install(FILES config/metamer.service DESTINATION lib/systemd/system)
install(FILES config/kiosk.ini DESTINATION ${CMAKE_INSTALL_SYSCONFDIR}/metamer)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/package_etc.cmake)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_CONTACT "The Metamer authors <metamer@packages.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "kiosk that shows what light does to color")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"Metamer puts a touch exhibit on a screen: a visitor picks a lamp, and one half
of the picture is computed the way screens usually do it (three numbers
multiplied), the other half wavelength by wavelength. It needs no more than
OpenGL ES 2, and renders, measures and checks exhibits without any display.")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
# Linked libraries are found in the program. Opened while it runs: the drivers behind libegl1 (Mesa's), and libudev,
# through which SDL hears of screens and touch panels. Data: the fonts of six languages.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS
    "libegl-mesa0, libgl1-mesa-dri, libudev1, fonts-dejavu-core, fonts-vlgothic, init-system-helpers (>= 1.54~)")
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA
    ${PROJECT_SOURCE_DIR}/packaging/conffiles ${PROJECT_SOURCE_DIR}/packaging/postinst
    ${PROJECT_SOURCE_DIR}/packaging/prerm ${PROJECT_SOURCE_DIR}/packaging/postrm)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
include(CPack)
