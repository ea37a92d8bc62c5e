# gatun_set_unity_groups(<target> <source>...)
#
# In a unity build (CMAKE_UNITY_BUILD), compiles up to ten sources of a folder together, and never those of
# two folders. Sources with compile options of their own are compiled alone.
function (gatun_set_unity_groups target)
  foreach (source IN LISTS ARGN)
    get_filename_component(folder "${source}" DIRECTORY)
    get_filename_component(folder "${folder}" NAME)
    if (NOT DEFINED "count_${folder}")
      set("count_${folder}" 0)
    endif ()
    math(EXPR group "${count_${folder}} / 10")
    math(EXPR "count_${folder}" "${count_${folder}} + 1")
    set_source_files_properties("${source}" PROPERTIES UNITY_GROUP "${folder}${group}")
  endforeach ()
  set_target_properties("${target}" PROPERTIES UNITY_BUILD_MODE GROUP)
endfunction ()
