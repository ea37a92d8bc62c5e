# With GATUN_PACKAGING, Debian packages by CPack, one for each install component. Utilities/setup.sh package
# makes the packages of both builds.
include(gatunDesktop)

if (NOT GATUN_PACKAGING)
  return ()
endif ()

#--------------------------------------------------------------------------------------------------
# The packages have in common:
set(GATUN_PACKAGE_MAINTAINER "Gatun maintainers <maintainers@gatun.invalid>" CACHE STRING
  "Maintainer of the Debian packages: a name and a mail address")
set(GATUN_PACKAGE_REVISION "1" CACHE STRING "Revision of the Debian packages, behind the version")

file(STRINGS /etc/os-release gatun_os REGEX "^VERSION_ID=")
string(REGEX REPLACE "[^0-9.]" "" gatun_os "${gatun_os}")
# The packages of a later Debian replace those of an earlier one.
set(gatun_package_release "${GATUN_PACKAGE_REVISION}~deb${gatun_os}")
set(gatun_package_version "${PROJECT_VERSION}-${gatun_package_release}")

set(CPACK_GENERATOR "DEB")
set(CPACK_PACKAGE_NAME "gatun")
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_PACKAGE_CONTACT "${GATUN_PACKAGE_MAINTAINER}")
set(CPACK_PACKAGING_INSTALL_PREFIX "${CMAKE_INSTALL_PREFIX}")
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_GROUPING "IGNORE")
set(CPACK_COMPONENTS_ALL)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME "DEB-DEFAULT")
set(CPACK_DEBIAN_COMPRESSION_TYPE "xz")
set(CPACK_DEBIAN_PACKAGE_RELEASE "${gatun_package_release}")
set(CPACK_DEBIAN_PACKAGE_SOURCE "gatun")
set(CPACK_DEBIAN_PACKAGE_PRIORITY "optional")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Gatun's own libraries are no packages yet when dependencies are looked up.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS
  "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")

# Breaks the lines of a paragraph.
function (gatun_wrap result text)
  set(lines)
  set(line)
  string(REPLACE " " ";" words "${text}")
  foreach (word IN LISTS words)
    string(LENGTH "${line} ${word}" length)
    if (line AND length GREATER 76)
      string(APPEND lines "${line}\n")
      set(line "${word}")
    elseif (line)
      string(APPEND line " ${word}")
    else ()
      set(line "${word}")
    endif ()
  endforeach ()
  set("${result}" "${lines}${line}" PARENT_SCOPE)
endfunction ()

# gatun_package(<component> NAME <package> SECTION <section> SUMMARY <line> DESCRIPTION <paragraph>...
#   [DEPENDS <dependency>...] [RECOMMENDS <dependency>...] [SUGGESTS <dependency>...]
#   [CONFLICTS <dependency>...] [CONTROL <file>...] [OVERRIDES <line>...] [LICENSE <name>] [SHARED] [ALL])
#
# The package of an install component. CONTROL: scripts and lists of dpkg. OVERRIDES: findings of
# lintian that are right as they are, with comments. LICENSE: Packaging/debian/copyright-<name>.in, in
# place of copyright.in. SHARED: it has shared libraries that other packages link. ALL: it is the same
# for every architecture.
function (gatun_package component)
  cmake_parse_arguments(PARSE_ARGV 1 arg
    "SHARED;ALL"
    "NAME;SECTION;SUMMARY;LICENSE"
    "DESCRIPTION;DEPENDS;RECOMMENDS;SUGGESTS;CONFLICTS;CONTROL;OVERRIDES")
  if (arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "gatun_package does not know ${arg_UNPARSED_ARGUMENTS}.")
  endif ()
  string(TOUPPER "${component}" key)
  foreach (list IN ITEMS DEPENDS RECOMMENDS SUGGESTS CONFLICTS)
    list(JOIN arg_${list} ", " arg_${list})
    set("CPACK_DEBIAN_${key}_PACKAGE_${list}" "${arg_${list}}" PARENT_SCOPE)
  endforeach ()
  set("CPACK_DEBIAN_${key}_PACKAGE_NAME" "${arg_NAME}" PARENT_SCOPE)
  set("CPACK_DEBIAN_${key}_PACKAGE_SECTION" "${arg_SECTION}" PARENT_SCOPE)
  set(paragraphs)
  foreach (paragraph IN LISTS gatun_about arg_DESCRIPTION)
    gatun_wrap(paragraph "${paragraph}")
    list(APPEND paragraphs "${paragraph}")
  endforeach ()
  list(JOIN paragraphs "\n\n" paragraphs)
  set("CPACK_DEBIAN_${key}_DESCRIPTION" "${arg_SUMMARY}\n${paragraphs}" PARENT_SCOPE)
  if (arg_SHARED)
    list(APPEND arg_CONTROL "${gatun_packaging_folder}/debian/triggers")
    list(APPEND arg_OVERRIDES
      "# CPack writes scripts that call ldconfig, next to the trigger that makes them superfluous."
      "${arg_NAME}: maintscript-calls-ldconfig *")
  endif ()
  set("CPACK_DEBIAN_${key}_PACKAGE_CONTROL_EXTRA" "${arg_CONTROL}" PARENT_SCOPE)
  if (arg_ALL)
    set("CPACK_DEBIAN_${key}_PACKAGE_ARCHITECTURE" "all" PARENT_SCOPE)
  endif ()
  list(APPEND CPACK_COMPONENTS_ALL "${component}")
  set(CPACK_COMPONENTS_ALL "${CPACK_COMPONENTS_ALL}" PARENT_SCOPE)

  # Each package has a copyright file and a list of its changes.
  set(folder "${CMAKE_BINARY_DIR}/packaging/${arg_NAME}")
  set(suffix)
  if (arg_LICENSE)
    set(suffix "-${arg_LICENSE}")
  endif ()
  configure_file("${gatun_packaging_folder}/debian/copyright${suffix}.in" "${folder}/copyright" @ONLY)
  string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
  configure_file("${gatun_packaging_folder}/debian/changelog.in" "${folder}/changelog.Debian" @ONLY)
  execute_process(
    COMMAND gzip --best --no-name --force "${folder}/changelog.Debian"
    COMMAND_ERROR_IS_FATAL ANY)
  install(FILES "${folder}/copyright" "${folder}/changelog.Debian.gz"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/${arg_NAME}"
    COMPONENT   "${component}")
  if (arg_OVERRIDES)
    list(JOIN arg_OVERRIDES "\n" overrides)
    file(WRITE "${folder}/overrides" "${overrides}\n")
    install(FILES "${folder}/overrides"
      DESTINATION "${CMAKE_INSTALL_DATADIR}/lintian/overrides"
      RENAME      "${arg_NAME}"
      COMPONENT   "${component}")
  endif ()
endfunction ()

file(READ LICENSE gatun_license)
string(REGEX REPLACE "^.*(Redistribution and use)" "\\1" gatun_license "${gatun_license}")
string(REGEX REPLACE "\n+$" "" gatun_license "${gatun_license}")
string(REPLACE "\n\n" "\n.\n" gatun_license "${gatun_license}")
string(REPLACE "\n" "\n " gatun_license " ${gatun_license}")

# The first paragraph of all descriptions.
set(gatun_about
  "Gatun is a set of VTK modules for losslessly compressed unstructured meshes. A file stores a grid or a \
surface (mesh.gtn) with all of its arrays and time steps, bit for bit, in a fraction of the size of \
compressed XML, or a regular volume (scan.ghv) as Hartley coefficients.")

# The next version of a package behind that of a library it must fit.
function (gatun_next_version version result)
  string(REGEX MATCH "^([0-9]+\\.[0-9]+\\.)([0-9]+)" version "${version}")
  math(EXPR patch "${CMAKE_MATCH_2} + 1")
  set("${result}" "${CMAKE_MATCH_1}${patch}~" PARENT_SCOPE)
endfunction ()

if (GATUN_BUILD_PARAVIEW_PLUGIN)
  include(gatunPackagesParaView)
else ()
  include(gatunPackagesVTK)
endif ()
include(CPack)
