// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// The default transfer function: frequent values are transparent and rare ones are not, whatever
// the values are.

#include "gatunDefaultOpacity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <vector>

namespace
{
using namespace gatun;

constexpr double Unit = 0.01 * 1.7320508; // a hundredth of the diagonal of a unit cube

/** Values that fill a unit cube. */
ValueSurvey MakeSurvey(const std::vector<double>& values)
{
  Range range = Range::MakeEmpty();
  for (const double value : values)
  {
    range.Include(value);
  }
  ValueSurvey survey;
  survey.Values = MakeValueHistogram(range,
    [&](ValueHistogram& histogram)
    {
      for (const double value : values)
      {
        histogram.Add(value, value, 1000);
      }
    });
  survey.Box[0] = survey.Box[1] = survey.Box[2] = { 0, 1 };
  survey.Volume = 1;
  return survey;
}

double GetOpacity(const DefaultTransfer& transfer, double value)
{
  const auto& nodes = transfer.Opacities;
  if (value <= nodes.front().Value || nodes.size() == 1)
  {
    return nodes.front().Opacity;
  }
  for (std::size_t i = 1; i < nodes.size(); ++i)
  {
    if (value <= nodes[i].Value)
    {
      const double t = (value - nodes[i - 1].Value) / (nodes[i].Value - nodes[i - 1].Value);
      return nodes[i - 1].Opacity * (1 - t) + nodes[i].Opacity * t;
    }
  }
  return nodes.back().Opacity;
}

/** The mean optical depth of a ray through the unit cube. */
double GetOpticalDepth(const DefaultTransfer& transfer, const std::vector<double>& values)
{
  constexpr double chord = 2.0 / 3;
  double sum = 0;
  for (const double value : values)
  {
    sum -= std::log1p(-GetOpacity(transfer, value)) / Unit * chord;
  }
  return sum / static_cast<double>(values.size());
}

void ExpectValid(const DefaultTransfer& transfer)
{
  EXPECT_LT(transfer.Colors.Min, transfer.Colors.Max);
  ASSERT_FALSE(transfer.Opacities.empty());
  EXPECT_LE(transfer.Opacities.size(), 129u);
  for (std::size_t i = 0; i < transfer.Opacities.size(); ++i)
  {
    const OpacityNode& node = transfer.Opacities[i];
    EXPECT_TRUE(std::isfinite(node.Value));
    EXPECT_GE(node.Opacity, 0);
    EXPECT_LT(node.Opacity, 1);
    EXPECT_TRUE(i == 0 || node.Value > transfer.Opacities[i - 1].Value);
  }
  EXPECT_EQ(transfer.Opacities.front().Value, transfer.Colors.Min);
  EXPECT_EQ(transfer.Opacities.back().Value, transfer.Colors.Max);
}

/** Nine tenths near one value, the others evenly from 0 to 1. */
std::vector<double> MakeMedium(double medium)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(0, 1);
  std::normal_distribution<double> near(medium, 0.01);
  std::vector<double> values;
  for (int i = 0; i < 20000; ++i)
  {
    values.push_back(i % 10 == 0 ? any(random) : near(random));
  }
  return values;
}

TEST(DefaultOpacity, TheMediumIsTransparentAndOtherValuesAreNot)
{
  for (const double medium : { 0.1, 0.5, 0.8 })
  {
    const auto values = MakeMedium(medium);
    const DefaultTransfer transfer = MakeDefaultTransfer(MakeSurvey(values), Unit);
    ExpectValid(transfer);
    const double ofMedium = GetOpacity(transfer, medium);
    EXPECT_LT(ofMedium, 0.005) << medium;
    for (const double other : { 0.02, 0.3, 0.65, 0.98 })
    {
      EXPECT_GT(GetOpacity(transfer, other), 4 * ofMedium) << medium << " " << other;
    }
    // Farther away is more opaque.
    const double far = medium < 0.5 ? 0.95 : 0.05;
    EXPECT_GT(GetOpacity(transfer, far), GetOpacity(transfer, (far + medium) / 2));
  }
}

TEST(DefaultOpacity, TheWholeIsNeitherEmptyNorSolid)
{
  std::vector<double> even;
  for (int i = 0; i <= 1000; ++i)
  {
    even.push_back(i);
  }
  for (const auto& values :
    { even, MakeMedium(0.1), MakeMedium(0.5), std::vector<double>(50, 4.0) })
  {
    const DefaultTransfer transfer = MakeDefaultTransfer(MakeSurvey(values), Unit);
    ExpectValid(transfer);
    const double depth = GetOpticalDepth(transfer, values);
    EXPECT_GT(depth, 0.2);
    EXPECT_LT(depth, 1.6);
  }
}

TEST(DefaultOpacity, AConstantIsAnEvenHaze)
{
  for (const double value : { 0.0, -7.0, 1e-300, 1e300 })
  {
    const DefaultTransfer transfer =
      MakeDefaultTransfer(MakeSurvey(std::vector<double>(10, value)), Unit);
    ExpectValid(transfer);
    EXPECT_LT(transfer.Colors.Min, value);
    EXPECT_GT(transfer.Colors.Max, value);
    for (const OpacityNode& node : transfer.Opacities)
    {
      EXPECT_EQ(node.Opacity, transfer.Opacities.front().Opacity);
      EXPECT_GT(node.Opacity, 0);
      EXPECT_LT(node.Opacity, 0.05);
    }
  }
}

TEST(DefaultOpacity, OutliersDoNotMatter)
{
  const auto values = MakeMedium(0.3);
  const DefaultTransfer expected = MakeDefaultTransfer(MakeSurvey(values), Unit);
  const double huge = std::numeric_limits<double>::max();
  const std::vector<std::vector<double>> cases{ { 1e4 }, { -1e30, 1e30 }, { huge, -huge },
    { 1e300 }, { std::numeric_limits<double>::infinity() } };
  for (const auto& outliers : cases)
  {
    auto more = values;
    more.insert(more.begin() + 100, outliers.begin(), outliers.end());
    const DefaultTransfer transfer = MakeDefaultTransfer(MakeSurvey(more), Unit);
    ExpectValid(transfer);
    SCOPED_TRACE(outliers[0]);
    // A range is narrowed if a twentieth of it or more is left out by that.
    EXPECT_NEAR(transfer.Colors.Min, expected.Colors.Min, 0.05);
    EXPECT_NEAR(transfer.Colors.Max, expected.Colors.Max, 0.05);
    for (const double value : { 0.3, 0.05, 0.6, 0.95 })
    {
      EXPECT_NEAR(GetOpacity(transfer, value), GetOpacity(expected, value),
        0.002 + 0.15 * GetOpacity(expected, value));
    }
  }
}

TEST(DefaultOpacity, LabelsThatAreRareStandOut)
{
  std::vector<double> labels(10000, 1);
  std::fill_n(labels.begin(), 400, 2.0);
  std::fill_n(labels.begin() + 5000, 300, 7.0);
  const DefaultTransfer transfer = MakeDefaultTransfer(MakeSurvey(labels), Unit);
  ExpectValid(transfer);
  EXPECT_EQ(transfer.Colors, (Range{ 1, 7 }));
  EXPECT_LT(GetOpacity(transfer, 1), 0.01);
  EXPECT_GT(GetOpacity(transfer, 7), 10 * GetOpacity(transfer, 1));
  EXPECT_GT(GetOpacity(transfer, 2), 2 * GetOpacity(transfer, 1));
}

TEST(DefaultOpacity, NearlyAConstantKeepsItsRange)
{
  std::vector<double> values(100000, 0);
  for (int i = 1; i <= 20; ++i)
  {
    values.push_back(i);
  }
  const DefaultTransfer transfer = MakeDefaultTransfer(MakeSurvey(values), Unit);
  ExpectValid(transfer);
  EXPECT_EQ(transfer.Colors, (Range{ 0, 20 }));
  EXPECT_GT(GetOpacity(transfer, 20), 20 * GetOpacity(transfer, 0));
}

TEST(DefaultOpacity, NoValuesAreNoProblem)
{
  const double nan = std::nan("");
  for (const auto& values : { std::vector<double>(), std::vector<double>{ nan, nan } })
  {
    ExpectValid(MakeDefaultTransfer(MakeSurvey(values), Unit));
  }
  auto values = MakeMedium(0.3);
  const auto expected = MakeDefaultTransfer(MakeSurvey(values), Unit).Opacities;
  values.insert(values.begin(), 1000, nan);
  EXPECT_EQ(MakeDefaultTransfer(MakeSurvey(values), Unit).Opacities, expected);
}

TEST(DefaultOpacity, TheOrderOfValuesAndTheUnitOfLengthDoNotMatter)
{
  auto values = MakeMedium(0.3);
  const DefaultTransfer expected = MakeDefaultTransfer(MakeSurvey(values), Unit);
  std::shuffle(values.begin(), values.end(), std::mt19937(5));
  ValueSurvey survey = MakeSurvey(values);
  EXPECT_EQ(MakeDefaultTransfer(survey, Unit).Opacities, expected.Opacities);
  for (Range& range : survey.Box)
  {
    range = { 500, 1500 };
  }
  survey.Volume = 1e9;
  const auto scaled = MakeDefaultTransfer(survey, 1000 * Unit).Opacities;
  ASSERT_EQ(scaled.size(), expected.Opacities.size());
  for (std::size_t i = 0; i < scaled.size(); ++i)
  {
    EXPECT_NEAR(scaled[i].Opacity, expected.Opacities[i].Opacity, 1e-9);
  }
}

TEST(DefaultOpacity, AGivenRangeIsKept)
{
  const auto values = MakeMedium(0.3);
  ValueSurvey survey = MakeSurvey(values);
  survey.Values = ValueHistogram({ 0.2, 0.4 });
  for (const double value : values)
  {
    survey.Values.Add(value, value, 1);
  }
  const Range range{ 0.2, 0.4 };
  const DefaultTransfer transfer = MakeDefaultTransfer(survey, Unit, range);
  ExpectValid(transfer);
  EXPECT_EQ(transfer.Colors, range);
  EXPECT_LT(GetOpacity(transfer, 0.3), GetOpacity(transfer, 0.4));
}

TEST(ValueHistogram, CountsPartsOfRangesExactly)
{
  ValueHistogram histogram({ 0, 8 });
  histogram.Add(0, 8, 80000000);
  histogram.Add(6, 6, 10000000);
  histogram.Add(100, 100, 5000000); // at the end
  histogram.Add(std::nan(""), 1, 77);
  EXPECT_EQ(histogram.GetTotal(), 95000000u);
  const auto fractions = histogram.GetFractions({ 0, 8 }, 4);
  for (const auto& [bin, weight] :
    { std::pair(0, 2000.), { 1, 2000. }, { 2, 2000. }, { 3, 3500. } })
  {
    EXPECT_NEAR(fractions[static_cast<std::size_t>(bin)], weight / 9500, 0.001);
  }
  // Another one with the same bins, added in parts.
  ValueHistogram sum = histogram.MakeEmpty();
  sum.Add(histogram);
  sum.Add(histogram);
  EXPECT_EQ(sum.GetTotal(), 190000000u);
  EXPECT_EQ(sum.GetFractions({ 0, 8 }, 4), fractions);
}
}
