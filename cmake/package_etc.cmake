# Before cpack makes the package: what a plain install keeps under its prefix belongs into /etc.
foreach(tree ${CPACK_TEMPORARY_INSTALL_DIRECTORY} ${CPACK_TEMPORARY_DIRECTORY})
    if(EXISTS ${tree}/usr/etc)
        file(RENAME ${tree}/usr/etc ${tree}/etc)
    endif()
endforeach()
