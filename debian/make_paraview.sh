#!/bin/sh
# make_paraview.sh FOLDER: makes a ParaView for developers out of the packages paraview and paraview-dev.
#
# ParaView's CMake package also needs python3-paraview, which cannot be installed in Debian 12 and 13: it excludes
# python3-vtk9, on which libvtk9-dev depends. Programs and Python modules are only looked for, and empty files stand for
# them. The hierarchy of classes, which wrapping reads, is made from the headers if a ParaView with a VTK of its own
# lacks it; one file has that of all modules.
set -eu
folder=$1
multiarch=$(dpkg-architecture -qDEB_HOST_MULTIARCH)
config=$(echo "/usr/lib/$multiarch/cmake/paraview-"*)
version=${config##*-}

rm -rf "$folder"
mkdir -p "$folder/bin" "$folder/lib/$multiarch/cmake"
ln -s /usr/include /usr/share "$folder"
find /usr/bin -mindepth 1 -exec ln -st "$folder/bin" {} +
find "/usr/lib/$multiarch" -mindepth 1 -maxdepth 1 ! -name cmake ! -name vtk \
  -exec ln -st "$folder/lib/$multiarch" {} +
cp -r "$config" "$folder/lib/$multiarch/cmake"
grep -rhoE '(bin/pv[a-z]+|lib/python3/[^" ]+\.so)' "$config" | sort -u | while read -r file; do
  [ -e "$folder/$file" ] || install -D /dev/null "$folder/$file"
done

if [ ! -d "$config/vtk" ]; then
  ln -s "/usr/lib/$multiarch/vtk" "$folder/lib/$multiarch"
  exit
fi

# Lines <header>;<library> of all modules that have a hierarchy.
awk -F'"' '
  /_vtk_module_library_name"/ { library = $6 }
  /_vtk_module_headers"/ { headers = $6 }
  /_vtk_module_hierarchy"/ { n = split(headers, h, ";"); for (i = 1; i <= n; i++) print h[i] ";" library }' \
  "$config/vtk/VTK-vtk-module-properties.cmake" "$config/ParaView-vtk-module-properties.cmake" |
  sed 's|${_vtk_module_import_prefix}|/usr|' >"$folder/headers.txt"
"vtkWrapHierarchy-pv$version" -o "$folder/hierarchy.txt" "-I/usr/include/paraview-$version" "$folder/headers.txt"
mkdir -p "$folder/lib/$multiarch/vtk/hierarchy/ParaView"
grep -rhoE "lib/$multiarch/vtk/hierarchy/ParaView/[^\"]+" "$config" | sort -u | while read -r file; do
  ln -s "$folder/hierarchy.txt" "$folder/$file"
done
