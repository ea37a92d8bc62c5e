// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunBorder.h"

#include "gatunBytePlan.h"
#include "gatunHartleyFile.h"
#include "gatunVolumeDescription.h"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

using namespace gatun;

/** An open file of a volume. */
struct gatun_volume
{
  explicit gatun_volume(std::unique_ptr<const HartleyFile> file)
    : File(std::move(file))
  {
  }

  const std::unique_ptr<const HartleyFile> File;
};

namespace
{
HartleyLayout::Triple TakeTriple(const uint32_t (&from)[3])
{
  return { from[0], from[1], from[2] };
}

VolumeInput TakeVolume(const gatun_volume_info& from, const gatun_buffer& values)
{
  VolumeInput own;
  own.Size = TakeTriple(from.dimensions);
  own.Type = TakeType(from.type);
  const auto voxels = Product(Product(from.dimensions[0], from.dimensions[1]), from.dimensions[2]);
  own.Values = TakeBuffer(values, Product(voxels, SizeOf(own.Type)), "the voxels");
  Need(own.Values != nullptr, "there are no voxels");
  own.Name = from.name ? from.name : "";
  own.VTKType = from.vtk_type;
  std::copy_n(from.origin, 3, own.Origin.begin());
  const auto isGiven = [](const double* numbers, std::size_t count)
  { return std::any_of(numbers, numbers + count, [](double number) { return number != 0; }); };
  if (isGiven(from.spacing, 3))
  {
    std::copy_n(from.spacing, 3, own.Spacing.begin());
  }
  if (isGiven(from.direction, 9))
  {
    std::copy_n(from.direction, 9, own.Direction.begin());
  }
  std::copy_n(from.first_index, 3, own.FirstIndex.begin());
  return own;
}
}

//------------------------------------------------------------------------------
gatun_status gatun_open_volume(const char* path, gatun_volume** volume)
{
  return Guard(
    [&]
    {
      NeedPointers(path, volume);
      *volume =
        std::make_unique<gatun_volume>(std::make_unique<const HartleyFile>(std::string(path)))
          .release();
    });
}

gatun_status gatun_open_volume_source(const gatun_source* source, gatun_volume** volume)
{
  return Guard(
    [&]
    {
      NeedPointers(source, volume);
      std::string name;
      auto bytes = WrapSource(source, name);
      *volume =
        std::make_unique<gatun_volume>(std::make_unique<const HartleyFile>(std::move(bytes), name))
          .release();
    });
}

void gatun_close_volume(gatun_volume* volume)
{
  delete volume;
}

//------------------------------------------------------------------------------
gatun_status gatun_get_volume_info(gatun_volume* volume, gatun_volume_info* info)
{
  return Guard(
    [&]
    {
      NeedPointers(volume, info);
      const auto& file = *volume->File;
      const auto& from = file.GetVolume();
      gatun_volume_info own{};
      std::copy(from.Size.begin(), from.Size.end(), own.dimensions);
      own.type = static_cast<gatun_type>(from.Type);
      own.name = from.Name.c_str();
      own.vtk_type = from.VTKType;
      std::copy(from.Origin.begin(), from.Origin.end(), own.origin);
      std::copy(from.Spacing.begin(), from.Spacing.end(), own.spacing);
      std::copy(from.Direction.begin(), from.Direction.end(), own.direction);
      std::copy(from.FirstIndex.begin(), from.FirstIndex.end(), own.first_index);
      own.range[0] = file.GetRange().Min;
      own.range[1] = file.GetRange().Max;
      own.rms_error = file.GetRMSError();
      own.maximum_error = file.GetMaximumError();
      own.is_lossless = file.IsLossless();
      own.file_bytes = file.GetFileBytes();
      own.bytes_read = file.GetBytesRead();
      Give(own, info);
    });
}

gatun_status gatun_describe_volume(
  gatun_volume* volume, int verbose, char* text, size_t capacity, size_t* length)
{
  return Guard(
    [&]
    {
      NeedPointers(volume, length);
      GiveText(WriteJson(DescribeVolume(*volume->File, false, verbose != 0).GetJson()), text,
        capacity, length);
    });
}

//------------------------------------------------------------------------------
gatun_status gatun_plan_voxels(gatun_volume* volume, const uint32_t first[3], const uint32_t end[3],
  uint64_t gap, gatun_range* ranges, size_t capacity, size_t* count)
{
  return Guard(
    [&]
    {
      NeedPointers(volume, first, end, count);
      GiveRanges(
        volume->File->GetByteRanges({ first[0], first[1], first[2] }, { end[0], end[1], end[2] }),
        {}, gap, ranges, capacity, count);
    });
}

gatun_status gatun_read_voxels(gatun_volume* volume, const uint32_t first[3], const uint32_t end[3],
  const gatun_buffer* values, gatun_progress progress, void* user)
{
  return Guard(
    [&]
    {
      NeedPointers(volume, first, end, values);
      const auto& file = *volume->File;
      std::size_t voxels = 1;
      for (int axis = 0; axis < 3; ++axis)
      {
        Need(first[axis] < end[axis], "there are no such voxels");
        voxels = Product(voxels, end[axis] - first[axis]);
      }
      void* const to =
        TakeBuffer(*values, Product(voxels, SizeOf(file.GetVolume().Type)), "the voxels");
      Need(to != nullptr, "there is no buffer for the voxels");
      file.GetVoxels({ first[0], first[1], first[2] }, { end[0], end[1], end[2] }, to,
        WrapProgress(progress, user));
    });
}

gatun_status gatun_verify_volume(gatun_volume* volume, gatun_progress progress, void* user)
{
  return Guard(
    [&]
    {
      NeedPointers(volume);
      volume->File->Verify(WrapProgress(progress, user));
    });
}

//------------------------------------------------------------------------------
gatun_status gatun_write_volume(const char* path, const gatun_volume_info* volume,
  const gatun_buffer* values, uint32_t block_size, gatun_rate rate, double rate_value,
  gatun_progress progress, void* user, gatun_volume_info* written)
{
  return Guard(
    [&]
    {
      NeedPointers(path, volume, values);
      Need(rate >= GATUN_QUALITY && rate <= GATUN_BITS_PER_VOXEL, "there is no such rate control");
      HartleyWriterOptions options;
      if (block_size > 0)
      {
        options.BlockSize = block_size == GATUN_ONE_BLOCK ? 0 : block_size;
      }
      options.RateControl.Mode = static_cast<HartleyRateMode>(rate);
      options.RateControl.Value = rate_value;
      const auto done = WriteHartleyFile(
        path, TakeVolume(Take(volume), *values), options, WrapProgress(progress, user));
      if (written)
      {
        auto own = Take(written);
        own.file_bytes = done.FileBytes;
        own.rms_error = done.RMSError;
        own.maximum_error = done.MaximumError;
        Give(own, written);
      }
    });
}
