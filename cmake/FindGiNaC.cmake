# SPDX-License-Identifier: GPL-3.0-or-later
# GiNaC and CLN through pkg-config: target GiNaC::GiNaC.
find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
  pkg_check_modules(GINAC QUIET IMPORTED_TARGET ginac cln)
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(GiNaC REQUIRED_VARS GINAC_LINK_LIBRARIES VERSION_VAR GINAC_ginac_VERSION)
if(GiNaC_FOUND AND NOT TARGET GiNaC::GiNaC)
  add_library(GiNaC::GiNaC INTERFACE IMPORTED)
  target_link_libraries(GiNaC::GiNaC INTERFACE PkgConfig::GINAC)
endif()
