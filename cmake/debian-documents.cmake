# SPDX-License-Identifier: MIT
# Run by cpack between installing into its folder and packing: what Debian expects of every package
# and no other installation needs: its copyright, a changelog and a compressed man page.

find_program(TABOR_GZIP gzip REQUIRED)
string(TIMESTAMP _date "%a, %d %b %Y %H:%M:%S +0000" UTC) # of SOURCE_DATE_EPOCH, if it is set
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER "${component}" _name)
  set(_folder "${CPACK_TEMPORARY_DIRECTORY}/${component}${CPACK_PACKAGING_INSTALL_PREFIX}/share")
  set(_documents "${_folder}/doc/${CPACK_DEBIAN_${_name}_PACKAGE_NAME}")
  file(MAKE_DIRECTORY "${_documents}")
  set(_license "${CPACK_RESOURCE_FILE_LICENSE}")
  # What contains sources of others has their licences beside it.
  file(GLOB_RECURSE _licenses "${CPACK_TEMPORARY_DIRECTORY}/${component}/*licenses.txt")
  if(_licenses)
    list(GET _licenses 0 _license)
  endif()
  file(COPY_FILE "${_license}" "${_documents}/copyright")
  file(WRITE "${_documents}/changelog.Debian"
"${CPACK_DEBIAN_${_name}_PACKAGE_NAME} (${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) unstable; urgency=medium

  * Version ${CPACK_PACKAGE_VERSION}. NEWS.md in the sources says what has changed.

 -- ${CPACK_PACKAGE_CONTACT}  ${_date}
")
  execute_process(COMMAND "${TABOR_GZIP}" -9nf "${_documents}/changelog.Debian" COMMAND_ERROR_IS_FATAL ANY)
  file(GLOB _pages "${_folder}/man/man1/*.1")
  foreach(_page IN LISTS _pages)
    execute_process(COMMAND "${TABOR_GZIP}" -9n "${_page}" COMMAND_ERROR_IS_FATAL ANY)
  endforeach()
endforeach()
