# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The properties of gatun_paraview.py, with names, defaults and words of the compiled plugin."""

_TIMES = """
<DoubleVectorProperty name="TimestepValues" information_only="1" repeatable="1" si_class="vtkSITimeStepsProperty">
  <Documentation>The available time values.</Documentation>
</DoubleVectorProperty>
"""


def _make_selection(kind):
    """Properties for the names of the arrays of points or cells and their check boxes."""
    return f"""
<StringVectorProperty name="{kind}ArrayInfo" command="Get{kind}DataArraySelection"
    number_of_elements_per_command="2" information_only="1" si_class="vtkSIDataArraySelectionProperty">
  <Documentation>The {kind.lower()} arrays of the file.</Documentation>
</StringVectorProperty>
<StringVectorProperty name="{kind}ArrayStatus" command="Get{kind}DataArraySelection"
    label="{kind} Arrays" information_property="{kind}ArrayInfo" number_of_elements_per_command="2"
    element_types="2 0" repeat_command="1" si_class="vtkSIDataArraySelectionProperty">
  <ArraySelectionDomain name="array_list">
    <RequiredProperties>
      <Property function="ArrayList" name="{kind}ArrayInfo" />
    </RequiredProperties>
  </ArraySelectionDomain>
  <Documentation>{kind} arrays to read. Others are skipped in the file. Default: all.</Documentation>
</StringVectorProperty>
"""


READER = (
    """
<StringVectorProperty name="FileNames" command="AddFileName" clean_command="RemoveAllFileNames"
    animateable="0" number_of_elements="0" number_of_elements_per_command="1" repeat_command="1"
    panel_visibility="never">
  <FileListDomain name="files" />
  <Documentation>Names of the .gtn files in the order of time. Default: none.</Documentation>
</StringVectorProperty>
"""
    + _TIMES
    + _make_selection("Point")
    + _make_selection("Cell")
    + """
<IntVectorProperty name="RestoreOrder" command="SetRestoreOrder" default_values="1" number_of_elements="1"
    panel_visibility="advanced">
  <BooleanDomain name="bool" />
  <Documentation>Restore the original order of points, cells and corners if the file stores it and one process
  reads the whole mesh. Default: on.</Documentation>
</IntVectorProperty>
<IntVectorProperty name="SplitCells" command="SetSplitCells" default_values="0" number_of_elements="1"
    panel_visibility="advanced">
  <BooleanDomain name="bool" />
  <Documentation>Read the tetrahedra that 3D cells consist of in place of the original cells. Default:
  off.</Documentation>
</IntVectorProperty>
<IntVectorProperty name="GenerateGlobalIds" command="SetGenerateGlobalIds" default_values="0"
    number_of_elements="1" panel_visibility="advanced">
  <BooleanDomain name="bool" />
  <Documentation>Always generate the arrays GlobalPointIds and GlobalCellIds, the indices of points and cells in
  the whole mesh, unless the file has global ids. If off, they are generated only where several processes read
  parts of the mesh. Default: off.</Documentation>
</IntVectorProperty>
<IntVectorProperty name="MemoryBudget" command="SetMemoryBudget" default_values="512" number_of_elements="1"
    panel_visibility="advanced">
  <IntRangeDomain name="range" min="0" />
  <Documentation>Memory for decoded parts of the file in each process, in MiB, so that other pieces, arrays and
  time steps need not decode them again. Default: 512.</Documentation>
</IntVectorProperty>
<DoubleVectorProperty name="SimplificationRatio" command="SetSimplificationRatio" default_values="0"
    number_of_elements="1">
  <DoubleRangeDomain name="range" min="0" max="1" />
  <Hints>
    <PropertyWidgetDecorator type="GenericDecorator" mode="enabled_state" property="HasHierarchy" value="1" />
  </Hints>
  <Documentation>Fraction of points removed, from 0 (none) to 1 (as many as possible). Greyed out if the file has
  no hierarchy (the property Hierarchy of the writer, or gtn pack --hierarchy). Default: 0.</Documentation>
</DoubleVectorProperty>
<IntVectorProperty name="Level" command="SetLevel" default_values="0" number_of_elements="1"
    panel_visibility="advanced">
  <IntRangeDomain name="range" min="0" max="64" />
  <Hints>
    <PropertyWidgetDecorator type="GenericDecorator" mode="enabled_state" property="HasHierarchy" value="1" />
  </Hints>
  <Documentation>Coarser mesh of the file to read in place of the mesh, from 1 for the finest one (the property
  Levels of the writer, or gtn pack --levels). 0: the mesh itself. Default: 0.</Documentation>
</IntVectorProperty>
<IntVectorProperty name="HasHierarchy" command="GetHasHierarchy" default_values="0" information_only="1"
    number_of_elements="1">
  <SimpleIntInformationHelper />
  <Documentation>Whether the file has a hierarchy, by which it can be simplified.</Documentation>
</IntVectorProperty>
<IntVectorProperty name="LargeMesh" command="SetLargeMesh" default_values="5000000" number_of_elements="1"
    panel_visibility="advanced">
  <Documentation>Largest mesh that is read in full if the file has its boundary, in tetrahedra, or cells of a
  surface. Of larger ones only the boundary is read. 0: the boundary of all meshes, -1: none. Default:
  5000000.</Documentation>
</IntVectorProperty>
<IntVectorProperty name="IsOnDemand" command="GetIsOnDemand" default_values="0" information_only="1"
    number_of_elements="1">
  <SimpleIntInformationHelper />
  <Documentation>Whether the output is currently the boundary.</Documentation>
</IntVectorProperty>
<DoubleVectorProperty name="Box" command="SetBox" default_values="1 -1 1 -1 1 -1" number_of_elements="6"
    panel_visibility="advanced">
  <Documentation>Region of interest: minimum and maximum of x, y and z, in the units of the coordinates. Chunks
  of the file, some ten thousand cells each, whose bounds do not intersect the box are skipped. If a minimum is
  larger than its maximum, there is no box. Default: 1 to -1, none.</Documentation>
</DoubleVectorProperty>
<StringVectorProperty name="ValueRangeArray" command="SetValueRangeArray" default_values=""
    number_of_elements="1" panel_visibility="advanced">
  <Documentation>Name of a point array, or else a cell array, of the value range. It need not be selected for
  reading. Chunks of the file, some ten thousand cells each, in which no value of it is in the range at the
  current time are skipped. Default: none, no chunk is skipped.</Documentation>
</StringVectorProperty>
<DoubleVectorProperty name="ValueRange" command="SetValueRange" default_values="0 1" number_of_elements="2"
    panel_visibility="advanced">
  <Documentation>Minimum and maximum value of interest, in the units of the array. Default: 0 to
  1.</Documentation>
</DoubleVectorProperty>
<IntVectorProperty name="ExactRegion" command="SetExactRegion" default_values="0" number_of_elements="1"
    panel_visibility="advanced">
  <BooleanDomain name="bool" />
  <Documentation>Read only the cells that meet the box and the value range, not all of their chunks. Default:
  off.</Documentation>
</IntVectorProperty>
<PropertyGroup label="Point and Cell Arrays" name="PointCellArrayStatus" panel_widget="ArrayStatus">
  <Property name="PointArrayStatus" />
  <Property name="CellArrayStatus" />
</PropertyGroup>
<PropertyGroup label="Order and Ids" panel_visibility="advanced">
  <Property name="RestoreOrder" />
  <Property name="SplitCells" />
  <Property name="GenerateGlobalIds" />
</PropertyGroup>
<PropertyGroup label="Memory" panel_visibility="advanced">
  <Property name="MemoryBudget" />
</PropertyGroup>
<PropertyGroup label="Simplification">
  <Property name="SimplificationRatio" />
  <Property name="Level" />
</PropertyGroup>
<PropertyGroup label="Reading on Demand" panel_visibility="advanced">
  <Property name="LargeMesh" />
</PropertyGroup>
<PropertyGroup label="Region of Interest" panel_visibility="advanced">
  <Property name="Box" />
  <Property name="ValueRangeArray" />
  <Property name="ValueRange" />
  <Property name="ExactRegion" />
</PropertyGroup>
"""
)

VOLUME_READER = """
<StringVectorProperty name="FileName" command="SetFileName" animateable="0" number_of_elements="1"
    panel_visibility="never">
  <FileListDomain name="files" />
  <Documentation>Name of the .ghv file to read. Default: none.</Documentation>
</StringVectorProperty>
"""

WRITER = """
<InputProperty name="Input" command="SetInputConnection" panel_visibility="never">
  <ProxyGroupDomain name="groups">
    <Group name="sources" />
    <Group name="filters" />
  </ProxyGroupDomain>
  <DataTypeDomain name="input_type" composite_data_supported="0">
    <DataType value="vtkUnstructuredGrid" />
    <DataType value="vtkPolyData" />
  </DataTypeDomain>
  <InputArrayDomain name="point_arrays" attribute_type="point" optional="1" />
  <Documentation>The mesh or surface to write. Merge blocks first, for example by Merge Blocks.</Documentation>
</InputProperty>
<StringVectorProperty name="FileName" command="SetFileName" number_of_elements="1" panel_visibility="never">
  <Documentation>Name of the .gtn file to write. Default: none.</Documentation>
</StringVectorProperty>
<IntVectorProperty name="KeepOrder" command="SetKeepOrder" default_values="0" number_of_elements="1">
  <EnumerationDomain name="enum">
    <Entry text="Nothing" value="0" />
    <Entry text="Points" value="1" />
    <Entry text="Cells" value="2" />
    <Entry text="Points and Cells" value="3" />
    <Entry text="Points, Cells and Corners" value="7" />
  </EnumerationDomain>
  <Documentation>The original order that the file stores for readers to restore. Stored orders make the file
  larger. Default: Nothing.</Documentation>
</IntVectorProperty>
<IntVectorProperty name="ChunkSize" command="SetChunkSize" default_values="0" number_of_elements="1"
    panel_visibility="advanced">
  <IntRangeDomain name="range" min="0" max="1048576" />
  <Documentation>Largest number of cells in a chunk, the smallest part that can be read, from 64 to 1048576. 0:
  by the size of the mesh. Small chunks make larger files. Default: 0.</Documentation>
</IntVectorProperty>
<IntVectorProperty name="Hierarchy" command="SetHierarchy" default_values="0" number_of_elements="1">
  <BooleanDomain name="bool" />
  <Documentation>Store a hierarchy of edge collapses, with which the mesh can be read and drawn with any number
  of points. Writing takes some more seconds per million cells. Default: off.</Documentation>
</IntVectorProperty>
<IntVectorProperty name="Levels" command="SetLevels" default_values="0" number_of_elements="1">
  <IntRangeDomain name="range" min="0" max="64" />
  <Hints>
    <PropertyWidgetDecorator type="GenericDecorator" mode="visibility" property="Hierarchy" value="1" />
  </Hints>
  <Documentation>Largest number of additional base meshes with an eighth of the points, a sixteenth, and so on. With
  them, coarse meshes are read and drawn faster. Default: 0.</Documentation>
</IntVectorProperty>
<IntVectorProperty name="WriteBoundary" command="SetWriteBoundary" default_values="0" number_of_elements="1">
  <BooleanDomain name="bool" />
  <Documentation>Store the boundary of the mesh, too. It is shown at once when the mesh is read on demand.
  Default: off.</Documentation>
</IntVectorProperty>
<StringVectorProperty name="LayerArray" command="SetLayerArray" default_values="(none)" number_of_elements="1">
  <ArrayListDomain name="array_list" input_domain_name="point_arrays" none_string="(none)">
    <RequiredProperties>
      <Property function="Input" name="Input" />
    </RequiredProperties>
  </ArrayListDomain>
  <Documentation>The point array by whose values the file is organized, so that isosurfaces read few chunks.
  This makes the file larger. With (none), the file is organized by position only. Default:
  (none).</Documentation>
</StringVectorProperty>
<IntVectorProperty name="NumberOfLayers" command="SetNumberOfLayers" default_values="0" number_of_elements="1"
    panel_visibility="advanced">
  <IntRangeDomain name="range" min="0" max="4096" />
  <Documentation>Largest number of layers of the value range; 0 for a number that suits the size of the mesh.
  Many layers make larger files. Default: 0.</Documentation>
</IntVectorProperty>
<IntVectorProperty name="WriteAllTimeSteps" command="SetWriteAllTimeSteps" default_values="0"
    number_of_elements="1">
  <BooleanDomain name="bool" />
  <Documentation>Write all time steps to the one file, also of a mesh whose points move or whose cells change.
  If off, only the current step is written. Default: off.</Documentation>
</IntVectorProperty>
<IntVectorProperty name="KeyStepInterval" command="SetKeyStepInterval" default_values="8" number_of_elements="1"
    panel_visibility="advanced">
  <IntRangeDomain name="range" min="1" />
  <Documentation>Interval of key steps, which are stored without reference to the previous step. Small intervals
  let readers jump between steps faster; large ones make smaller files. Default: 8.</Documentation>
  <Hints>
    <PropertyWidgetDecorator type="GenericDecorator" mode="visibility" property="WriteAllTimeSteps" value="1" />
  </Hints>
</IntVectorProperty>
<StringVectorProperty name="PointTolerance" command="SetPointTolerance" default_values="" number_of_elements="1"
    panel_visibility="advanced">
  <Documentation>How coordinates are rounded, which can make the file smaller: abs:E changes each of them by at
  most E, in their units; rel:E by at most E times the longest side of the bounding box; bits:N gives that side
  2^N places. Values of arrays stay. Default: none, without loss.</Documentation>
</StringVectorProperty>
<StringVectorProperty name="ArrayTolerances" command="AddArrayTolerance" clean_command="ClearArrayTolerances"
    number_of_elements="0" number_of_elements_per_command="1" repeat_command="1" panel_visibility="advanced">
  <Documentation>How much the values of arrays may change, one array a line: pressure=rel:1e-3,
  velocity=abs:0.01, or *=pw:1e-4 for all floating-point arrays that are not named. rel: relative to the range
  of the values at the time step; abs: a difference; pw: relative to each value; bits:N: N significant binary
  digits. With ",zeros" at the end, values of 0 stay exact. Default: none, without loss.</Documentation>
  <Hints>
    <ShowLabel />
  </Hints>
</StringVectorProperty>
<IntVectorProperty name="FillMissingArrays" command="SetFillMissingArrays" default_values="0"
    number_of_elements="1" panel_visibility="advanced">
  <BooleanDomain name="bool" />
  <Documentation>Let arrays come and go with time: a time step that lacks an array of another one gets it, with
  NaN, or 0 if it is of integers. Default: off.</Documentation>
</IntVectorProperty>
<IntVectorProperty name="Profile" command="SetProfile" default_values="1" number_of_elements="1">
  <EnumerationDomain name="enum">
    <Entry text="Fast" value="1" />
    <Entry text="Small" value="0" />
  </EnumerationDomain>
  <Documentation>Whether the file is optimized for reading speed or for size. Fast files are read several times
  faster and take up to twice the space. Default: Fast.</Documentation>
</IntVectorProperty>
"""
