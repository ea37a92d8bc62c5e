// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnFileOrder.h"

#include "gtnFailure.h"
#include "gtnMessages.h"
#include "gtnText.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <numeric>
#include <system_error>

namespace gtn
{
namespace
{

const char* const HowToGiveTimes = "; a .pvd file that lists the files can give them times";

bool IsDigit(char c)
{
  return c >= '0' && c <= '9';
}

/** A name as numbers and the text around them. */
struct NumberedName
{
  std::string Text;                 ///< with # in place of numbers
  std::vector<std::string> Numbers; ///< their digits
};

NumberedName SplitName(const std::string& file)
{
  NumberedName name;
  for (std::size_t i = 0; i < file.size();)
  {
    std::size_t end = i;
    while (end < file.size() && IsDigit(file[end]))
    {
      ++end;
    }
    if (end > i)
    {
      name.Text += '#';
      name.Numbers.push_back(file.substr(i, end - i));
    }
    else
    {
      name.Text += file[end++];
    }
    i = end;
  }
  return name;
}

// Compares whole numbers of any size.
int CompareWhole(const std::string& a, const std::string& b)
{
  const auto start = [](const std::string& digits)
  { return std::min(digits.find_first_not_of('0'), digits.size()); };
  const std::string first = a.substr(start(a));
  const std::string second = b.substr(start(b));
  return first.size() != second.size() ? (first.size() < second.size() ? -1 : 1)
                                       : first.compare(second);
}

// Whether a name comes before another one that differs in numbers only. asFractions: a number after
// a point that follows a number is what stands behind the point of a decimal.
bool ComesBefore(const NumberedName& a, const NumberedName& b, bool asFractions)
{
  std::size_t place = a.Text.find('#');
  for (std::size_t i = 0; i < a.Numbers.size(); ++i)
  {
    const bool isFraction = asFractions && place >= 2 && a.Text.substr(place - 2, 2) == "#.";
    const int order =
      isFraction ? a.Numbers[i].compare(b.Numbers[i]) : CompareWhole(a.Numbers[i], b.Numbers[i]);
    if (order != 0)
    {
      return order < 0;
    }
    place = a.Text.find('#', place + 1);
  }
  return a.Numbers < b.Numbers; // 1 and 01
}

std::vector<std::size_t> OrderNames(const std::vector<NumberedName>& names, bool asFractions)
{
  std::vector<std::size_t> order(names.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::stable_sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b) { return ComesBefore(names[a], names[b], asFractions); });
  return order;
}

void OrderByNames(std::vector<TimedFile>& files, bool quiet)
{
  std::vector<NumberedName> names;
  for (const TimedFile& file : files)
  {
    names.push_back(SplitName(file.File));
  }
  const bool areNumbered = std::all_of(names.begin(), names.end(),
    [&](const NumberedName& name) { return name.Text == names.front().Text; });
  if (areNumbered)
  {
    const std::vector<std::size_t> order = OrderNames(names, false);
    if (std::is_sorted(order.begin(), order.end()))
    {
      // They are in this order.
    }
    else if (order != OrderNames(names, true))
    {
      if (!quiet)
      {
        Say(fmt::format("{}: the steps are in the order of the command line, as the names can be "
                        "read as whole numbers and as decimals{}",
          files.front().File, HowToGiveTimes));
      }
    }
    else
    {
      std::vector<TimedFile> sorted;
      for (const std::size_t number : order)
      {
        sorted.push_back(files[number]);
      }
      files = sorted;
      if (!quiet)
      {
        Say(fmt::format("{}: the steps are in the order of the numbers in the names, up to {}",
          files.front().File, FileOf(files.back().File)));
      }
    }
  }
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    files[i].Time = static_cast<double>(i);
  }
}

bool IsSameFile(const std::string& a, const std::string& b)
{
  std::error_code error;
  return std::filesystem::equivalent(a, b, error) && !error;
}

} // anonymous namespace

//------------------------------------------------------------------------------
std::vector<TimedFile> OrderFiles(std::vector<TimedFile> files, bool quiet)
{
  const auto hasTime = [](const TimedFile& file) { return file.Time.has_value(); };
  const auto timed = std::find_if(files.begin(), files.end(), hasTime);
  const auto timeless = std::find_if_not(files.begin(), files.end(), hasTime);
  if (timed == files.end())
  {
    OrderByNames(files, quiet);
    return files;
  }
  if (timeless != files.end())
  {
    throw Failure(timeless->File,
      fmt::format("has no time (field array TimeValue), and {} has the time {}{}", timed->File,
        DescribeNumber(*timed->Time), HowToGiveTimes));
  }
  for (const TimedFile& file : files)
  {
    if (!std::isfinite(*file.Time))
    {
      throw Failure(file.File,
        fmt::format("has the time {} (field array TimeValue), which is not finite{}",
          DescribeNumber(*file.Time), HowToGiveTimes));
    }
  }
  std::stable_sort(files.begin(), files.end(),
    [](const TimedFile& a, const TimedFile& b) { return *a.Time < *b.Time; });
  std::vector<TimedFile> ordered;
  for (const TimedFile& file : files)
  {
    if (ordered.empty() || *ordered.back().Time != *file.Time)
    {
      ordered.push_back(file);
    }
    else if (!IsSameFile(ordered.back().File, file.File))
    {
      throw Failure(file.File,
        fmt::format("has the time {} (field array TimeValue), as {} has{}",
          DescribeNumber(*file.Time), ordered.back().File, HowToGiveTimes));
    }
  }
  return ordered;
}
}
