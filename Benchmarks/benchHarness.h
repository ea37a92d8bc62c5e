// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef benchHarness_h
#define benchHarness_h

// How things are measured, and how figures are told.

#include "gtnFailure.h"
#include "gtnJson.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace bench
{
using gtn::Failure;

double SecondsOf(const std::function<void()>& work);

/** Something to be timed, next to others. */
struct Operation
{
  std::string Name;
  std::function<void()> Run;
  int MostRounds = 1000; ///< for what is too slow to be run as often as the others
  double First = 0;      ///< seconds of the first run, which counts for nothing else
  std::vector<double> Seconds = {};
};

/**
 * Runs all operations in rounds, each operation once a round, so that what disturbs the machine
 * disturbs all alike. Every other round goes backwards.
 */
void RunInterleaved(std::vector<Operation>& operations, int rounds);

/** Runs all operations once before, which counts for nothing but Operation::First. */
void WarmUpAndRunInterleaved(std::vector<Operation>& operations, int rounds);

/** Adds a list of numbers. */
void AddList(Json::Value& json, const char* name, const std::vector<double>& values);

/** What some work takes: seconds, and bytes of memory before it and at most. (At most since the
 * start of the process, where the system cannot forget the peak.) */
struct Cost
{
  double Seconds;
  std::uint64_t Before;
  std::uint64_t Peak;
};

Cost CostOf(const std::function<void()>& work);

/** Adds seconds, before and peak. */
void AddCost(Json::Value& json, const Cost& cost);

/** The branches that the processor mispredicts while this thread does some work; nothing where the
 * system does not count them. */
std::optional<std::uint64_t> CountBranchMisses(const std::function<void()>& work);

std::uint64_t FileSize(const std::string& file);
}

#endif
