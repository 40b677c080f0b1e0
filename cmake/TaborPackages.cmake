# SPDX-License-Identifier: MIT
# Debian packages by `cpack -G DEB` in the build folder: the library, what building against it takes,
# the program, and the plugins of each format. For packages that belong into a system's folders configure with
#
#   -DCMAKE_INSTALL_PREFIX=/usr -DBUILD_SHARED_LIBS=ON

set(CPACK_PACKAGE_NAME tabor)
string(REPLACE "-" "~" CPACK_PACKAGE_VERSION "${TABOR_VERSION}") # 0.2.0~dev comes before 0.2.0
set(CPACK_PACKAGE_VENDOR Tabor)
include("${CMAKE_CURRENT_LIST_DIR}/TaborIdentity.cmake")
# Debian wants an address. Without one in the identity packages are for the machine that makes them: tools/release refuses.
if(TABOR_IDENTITY_ADDRESS)
  set(CPACK_PACKAGE_CONTACT "${TABOR_IDENTITY_NAME} <${TABOR_IDENTITY_ADDRESS}>")
else()
  set(CPACK_PACKAGE_CONTACT "${TABOR_IDENTITY_NAME} <maintainers@tabor.invalid>")
endif()
if(TABOR_IDENTITY_REPOSITORY)
  set(CPACK_DEBIAN_PACKAGE_HOMEPAGE "${TABOR_IDENTITY_REPOSITORY}")
endif()
string(REGEX REPLACE "^A " "" CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}") # Debian wants no article
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_STRIP_FILES ON)
set(CPACK_GENERATOR DEB)
set(CPACK_COMPONENTS_ALL library development)
if(TABOR_BUILD_PROGRAM)
  list(APPEND CPACK_COMPONENTS_ALL program)
endif()
if(TABOR_BUILD_LV2)
  list(APPEND CPACK_COMPONENTS_ALL lv2)
endif()
if(TABOR_BUILD_CLAP)
  list(APPEND CPACK_COMPONENTS_ALL clap)
endif()
if(TABOR_BUILD_VST3)
  list(APPEND CPACK_COMPONENTS_ALL vst3)
endif()
set(CPACK_PRE_BUILD_SCRIPTS "${CMAKE_CURRENT_LIST_DIR}/debian-documents.cmake")
set(TABOR_DEBIAN_LIBRARY "libtabor${TABOR_SOVERSION}")

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${PROJECT_BINARY_DIR}/engine")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SECTION sound)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(TABOR_DEBIAN_ABOUT
    "The sound is computed from the drum's physics: heads that move the air,
wires that bounce on them, a stick that strikes. No sound is sampled and no
envelope is drawn.")

set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME "${TABOR_DEBIAN_LIBRARY}")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA "${CMAKE_CURRENT_LIST_DIR}/debian/triggers") # ldconfig
set(CPACK_DEBIAN_LIBRARY_DESCRIPTION "${TABOR_DEBIAN_ABOUT}\nThis is the library.")

set(TABOR_DEBIAN_SAME_VERSION
    "${TABOR_DEBIAN_LIBRARY} (= ${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libtabor-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "${TABOR_DEBIAN_SAME_VERSION}")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION
    "${TABOR_DEBIAN_ABOUT}\nThis is what building programs against the library takes.")

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME tabor)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "${TABOR_DEBIAN_ABOUT}\nThis is the program tabor, which renders sound files.")

set(CPACK_DEBIAN_LV2_PACKAGE_NAME tabor-lv2)
set(CPACK_DEBIAN_LV2_DESCRIPTION "${TABOR_DEBIAN_ABOUT}\nThese are the instruments for LV2 plugin hosts.")

set(CPACK_DEBIAN_CLAP_PACKAGE_NAME tabor-clap)
set(CPACK_DEBIAN_CLAP_DESCRIPTION "${TABOR_DEBIAN_ABOUT}\nThese are the instruments for CLAP plugin hosts.")

set(CPACK_DEBIAN_VST3_PACKAGE_NAME tabor-vst3)
set(CPACK_DEBIAN_VST3_DESCRIPTION "${TABOR_DEBIAN_ABOUT}\nThese are the instruments for VST3 plugin hosts.")

# It reads the sound files of a kit; plugins load without it.
foreach(component IN ITEMS LV2 CLAP VST3)
  set(CPACK_DEBIAN_${component}_PACKAGE_RECOMMENDS libsndfile1)
endforeach()

if(BUILD_SHARED_LIBS)
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "${TABOR_DEBIAN_SAME_VERSION}")
else()
  # A static library is needed by nobody who runs programs.
  list(REMOVE_ITEM CPACK_COMPONENTS_ALL library)
endif()

include(CPack)
