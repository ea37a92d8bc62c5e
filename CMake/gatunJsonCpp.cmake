# The target JsonCpp::JsonCpp. VTK's package may have made it already, which that of jsoncpp does not expect.
if (NOT TARGET JsonCpp::JsonCpp)
  find_package(jsoncpp REQUIRED)
endif ()
