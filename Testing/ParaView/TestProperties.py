# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Every property in the plugin's XML is documented, its command exists in the class and does what
the name says, and its default is that of the class."""

import glob
import os
import sys
import xml.etree.ElementTree as tree

import gatunSample as sample
from gatunParaView import load_plugin
from paraview import servermanager

simple = load_plugin()
folder = sys.argv[1]
# What a property is set to, to see whether that arrives.
OTHER = {"ChunkSize": [1000], "KeepOrder": [7], "KeyStepInterval": [3],
         "Box": [6, 5, 4, 3, 2, 1], "ValueRange": [-4, 9],
         "ValueRangeArray": ["some array"], "FileName": ["some file"],
         "LargeMesh": [2000000000], "SampleDistance": [0.25], "BlendMode": [101],
         "MemoryBudget": [100], "TimeBudget": [0.5], "MaximumError": [0.125], "Metric": [1],
         "BoundaryWeight": [0.75], "FeatureAngle": [45.0], "ArrayComponent": [2], "OutputPointsPrecision": [1],
         "Levels": [5], "LayerArray": ["some array"], "LayerComponent": [1], "NumberOfLayers": [9],
         "LayerSpacing": [2], "SimplificationRatio": [0.25],
         "SimplificationNumberOfPoints": [123], "SimplificationRMSError": [0.125],
         "BlockSize": [16], "RateControl": [2], "Quality": [33], "PSNR": [44], "BitsPerVoxel": [2],
         "RMSError": [0.125],
         "FrequencyWeight": [1.5], "ViewDirection": [1, 2, 3], "ViewUp": [0, 2, 1], "Zoom": [3],
         "Size": [64, 32], "OpacityModel": [1], "ColorMap": [3], "ValueRange": [-4, 9], "OpacityUnit": [5],
         "Extinction": [0.5], "Zero": [-3], "Window": [2, 7], "Background": [0.5, 0.25, 1],
         "Method": [2], "NumberOfPieces": [7], 
         "MinTimeStep": [2], "MaxTimeStep": [5], "TimeStepStride": [3],
         "HartleyOpacityModel": [1], "HartleyMemoryBudget": [100],
         "PointTolerance": ["bits:14"], "Style": [1]}
# Where people who open a file are better served by another default than programs: that of the class.
OWN_DEFAULT = {"GatunReaderCore.LargeMesh": [-1], "GatunSurfaceReaderCore.LargeMesh": [-1],
               "GatunReaderCore.PrefetchTimeSteps": [0],
               "GatunSurfaceReaderCore.PrefetchTimeSteps": [0],
               "GatunWriter.LayerArray": ["none"],
               "GatunContour.ComputeNormals": [0],
               "GatunVolumeDetailPolicy.JustInTime": [0], "GatunVolumeDetailPolicy.TimeBudget": [0],
               "GatunSurfaceDetailPolicy.JustInTime": [0], "GatunSurfaceDetailPolicy.TimeBudget": [0],
               "GatunContour.ArrayComponent": [-1]}
# Commands of ParaView's own classes, which have no Get.
OF_PARAVIEW = {"SetVisibility", "SetForceUseCache", "SetForcedCacheKey", "SetScalarOpacityUnitDistance",
               "SetPosition", "SetScale", "SetOrientation", "SetOrigin", "SetPickable", "SetColor",
               "SetScalarOpacity"}
HELPERS = {"IntVectorProperty": "SimpleIntInformationHelper",
           "DoubleVectorProperty": "SimpleDoubleInformationHelper",
           "IdTypeVectorProperty": "SimpleIdTypeInformationHelper",
           "StringVectorProperty": "SimpleStringInformationHelper"}

problems = []
proxies = []
bases = {}
for path in sorted(glob.glob(os.path.join(folder, "*.xml"))):
    for group in tree.parse(path).getroot().findall("ProxyGroup"):
        for proxy in group:
            if not proxy.get("class"):
                bases[proxy.get("name")] = proxy
                continue
            for node in bases.get(proxy.get("base_proxyname"), ()):
                proxy.append(node)
            proxies.append((group.get("name"), proxy))


def values_of(node):
    text = node.get("default_values")
    if text is None:
        return None
    if node.tag == "StringVectorProperty":
        return [text]
    return [float(word) for word in text.split()]


def look(smproxy, node):
    """What the VTK object answers when asked by the property's Get; a string that is not there stays
    "none"."""
    smproxy.UpdatePropertyInformation()
    prop = smproxy.GetProperty("Ask" + node.get("name"))
    return [prop.GetElement(i) for i in range(prop.GetNumberOfElements())]


def asking(name, proxy, nodes):
    """A proxy of the same class that sets nothing by itself but asks for all."""
    parts = ['<ServerManagerConfiguration><ProxyGroup name="asking"><Proxy name="%s" class="%s">'
             % (name, proxy.get("class"))]
    for node in nodes:
        common = (node.tag, node.get("name"), node.get("number_of_elements"))
        parts.append('<%s name="%s" number_of_elements="%s" default_values="none" command="%s"/>'
                     % (*common, node.get("command")))
        parts.append('<%s name="Ask%s" number_of_elements="%s" default_values="none" command="Get%s" '
                     'information_only="1"><%s/></%s>'
                     % (*common, node.get("command")[3:], HELPERS[node.tag], node.tag))
    parts.append("</Proxy></ProxyGroup></ServerManagerConfiguration>")
    manager = servermanager.ProxyManager()
    definitions = manager.SMProxyManager.GetProxyDefinitionManager()
    assert definitions.LoadConfigurationXMLFromString("".join(parts))
    made = manager.NewProxy("asking", name)
    made.UpdateVTKObjects()
    return made


checked = 0
for group, proxy in proxies:
    owner = proxy.get("name")
    if proxy.find("Documentation") is None:
        problems.append(owner + " has no documentation")
    plain = []
    for node in proxy:
        if not node.tag.endswith("Property"):
            continue
        what = "%s.%s" % (owner, node.get("name"))
        text = " ".join((node.findtext("Documentation") or "").split())
        if not text:
            problems.append(what + " has no documentation")
        if node.tag == "InputProperty" or node.get("information_only") == "1":
            continue
        if "Default:" not in text:
            problems.append(what + " does not tell its default")
        if proxy.get("class").startswith("vtkGatun") and node.get("repeat_command") != "1" \
                and node.get("command") != "SetInputArrayToProcess" \
                and node.get("command") not in OF_PARAVIEW:
            plain.append(node)
            if values_of(node) is None and node.get("name") != "FileName":
                problems.append(what + " has no default")
    if not plain:
        continue
    asked = asking("As" + owner, proxy, plain)
    for node in plain:
        name = node.get("name")
        what = "%s.%s" % (owner, name)
        default = values_of(node)
        own = look(asked, node)
        if what in OWN_DEFAULT:
            if own != OWN_DEFAULT[what]:
                problems.append("%s: in C++ %s, not %s" % (what, own, OWN_DEFAULT[what]))
        elif default is not None and own != default and own not in ([], [None], ["none"]) or \
                default not in (None, [""]) and own in ([], [None], ["none"]):
            problems.append("%s: default %s, in C++ %s" % (what, default, own))
        # On, if it is off, and so on.
        other = OTHER.get(name) or [1 - int(default[0])]
        prop = asked.GetProperty(name)
        for i, value in enumerate(other):
            prop.SetElement(i, value)
        asked.UpdateVTKObjects()
        if look(asked, node) != other:
            problems.append("%s: set to %s, is %s" % (what, other, look(asked, node)))
        checked += 1

assert not problems, "\n" + "\n".join(problems)
assert checked >= 20, checked
assert {proxy.get("class") for _, proxy in proxies} >= \
    {"vtkGatunReader", "vtkGatunSurfaceReader", "vtkGatunPVWriter", "vtkGatunPVMergeBlocks", "vtkGatunVolumeRepresentation",
     "vtkGatunSurfaceRepresentation", "vtkGatunDetailPolicy", "vtkGatunHartleyEncoding",
     "vtkGatunHartleyRepresentation",
     "vtkGatunHartleyEncoder", "vtkGatunHartleyReader", "vtkGatunHartleyWriter",
     "vtkGatunPVProjection", "vtkGatunSplitBlocks"}

# The reader and the writer that people get have the properties of those that do the work.
path = sample.temporary("properties.gtn")
writer = simple.CreateWriter(path, sample.make_source())
for prop in ("KeepOrder", "ChunkSize", "SplitCells", "FileName",
             "ChooseArraysToWrite", "WriteAllTimeSteps", "KeyStepInterval", "NumberOfPieces",
             "PointTolerance", "ArrayTolerances", "FillMissingArrays", "Profile"):
    assert writer.GetProperty(prop) is not None, prop
writer.UpdatePipeline()
reader = simple.GatunReader(FileNames=[path])
core = next(proxy for _, proxy in proxies if proxy.get("name") == "GatunReaderCore")
for node in core:
    if node.tag.endswith("Property") and node.get("name") not in ("FileName", "TimestepValues"):
        assert reader.GetProperty(node.get("name")) is not None, node.get("name")

# So it is with the representation.
shown = simple.Show(reader, simple.CreateRenderView())
representation = next(proxy for _, proxy in proxies
                      if proxy.get("name") == "GatunVolumeRepresentation")
for node in representation.iter():
    if node.tag.endswith("Property"):
        assert shown.GetProperty(node.get("name")) is not None, node.get("name")
