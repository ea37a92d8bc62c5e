# The target JsonCpp::JsonCpp: that of the system, or one that is compiled from its sources.
set(GATUN_JSONCPP_SOURCE "" CACHE PATH
  "Folder of jsoncpp's sources, which are compiled into a static library; empty for the jsoncpp of the system")

# VTK's package may have made it already, which that of jsoncpp does not expect.
if (TARGET JsonCpp::JsonCpp)
  return ()
endif ()
if (NOT GATUN_JSONCPP_SOURCE)
  find_package(jsoncpp REQUIRED)
  return ()
endif ()

add_library(gatunJsonCpp STATIC
  "${GATUN_JSONCPP_SOURCE}/src/lib_json/json_reader.cpp"
  "${GATUN_JSONCPP_SOURCE}/src/lib_json/json_value.cpp"
  "${GATUN_JSONCPP_SOURCE}/src/lib_json/json_writer.cpp")
set_target_properties(gatunJsonCpp PROPERTIES
  POSITION_INDEPENDENT_CODE ON
  UNITY_BUILD               OFF)
target_include_directories(gatunJsonCpp SYSTEM PUBLIC "${GATUN_JSONCPP_SOURCE}/include")
add_library(JsonCpp::JsonCpp ALIAS gatunJsonCpp)
