// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Files that several processes write together, against those that one writes. The processes are
// threads.

#include "gatunHostile.h"
#include "gatunMeshParts.h"
#include "gatunPartExchange.h"

#include <gtest/gtest.h>

#include <barrier>
#include <random>
#include <thread>

namespace
{
using namespace gatun;
using namespace gatun::test;

/** Where threads leave their messages. */
struct Board
{
  explicit Board(std::size_t processes)
    : Messages(processes)
    , Barrier(static_cast<std::ptrdiff_t>(processes))
  {
  }

  std::vector<std::vector<PartExchange::Message>> Messages;
  std::barrier<> Barrier;
};

class ThreadExchange : public PartExchange
{
public:
  ThreadExchange(Board& board, std::size_t process)
    : Shared(board)
    , Process(process)
  {
  }

  int GetProcess() const override { return static_cast<int>(this->Process); }
  int GetProcesses() const override { return static_cast<int>(this->Shared.Messages.size()); }

  std::vector<Message> Exchange(std::vector<Message> messages) override
  {
    this->Shared.Messages[this->Process] = std::move(messages);
    this->Shared.Barrier.arrive_and_wait();
    std::vector<Message> received;
    for (const auto& sent : this->Shared.Messages)
    {
      received.push_back(sent[this->Process]);
    }
    this->Shared.Barrier.arrive_and_wait();
    return received;
  }

private:
  Board& Shared;
  const std::size_t Process;
};

using Processes = std::vector<std::vector<PartMesh>>;

/** What may go wrong in a process. */
struct Fault
{
  std::size_t Process = ~std::size_t{ 0 };
  bool Surveying = true;
  int Steps = 0; // further ones
};

/** Writes a file and returns the messages of the errors. */
std::vector<std::string> WriteTogether(const std::string& path, const Processes& processes,
  const PartWriterOptions& options, int steps, bool withIds, const Fault& fault = {})
{
  Board board(processes.size());
  std::vector<std::string> errors(processes.size());
  const auto run = [&](std::size_t process)
  {
    ThreadExchange exchange(board, process);
    const bool fails = process == fault.Process;
    try
    {
      std::unique_ptr<PartWriter> writer;
      exchange.Together([&]
        { writer = std::make_unique<PartWriter>(path, PartMesh::Describe(), options, &exchange); });
      exchange.Together(
        [&]
        {
          for (const auto& part : processes[process])
          {
            writer->Survey(part.GetInput(), withIds ? part.PointIds.data() : nullptr);
            for (int step = 0; step < steps + (fails ? fault.Steps : 0); ++step)
            {
              writer->SurveyStep(PartValues(part, step).Get());
            }
          }
          if (fails && fault.Steps == 0 && fault.Surveying)
          {
            ThrowInvalid("out of luck");
          }
        });
      writer->EndSurvey();
      exchange.Together(
        [&]
        {
          for (const auto& part : processes[process])
          {
            writer->Write(part.GetInput(), withIds ? part.PointIds.data() : nullptr);
            for (int step = 0; step < steps; ++step)
            {
              writer->WriteStep(PartValues(part, step).Get(), {}, steps > 1, step);
            }
          }
          if (fails && !fault.Surveying)
          {
            ThrowInvalid("out of luck");
          }
        });
      writer->Finish();
    }
    catch (const std::exception& error)
    {
      errors[process] = error.what();
    }
  };
  std::vector<std::thread> threads;
  for (std::size_t process = 0; process < processes.size(); ++process)
  {
    threads.emplace_back(run, process);
  }
  for (auto& thread : threads)
  {
    thread.join();
  }
  return errors;
}

PartWriterOptions MakeProcessOptions(std::uint8_t keep)
{
  PartWriterOptions options;
  options.File.ChunkSize = 200;
  options.File.KeyStepInterval = 3;
  options.File.Keep = keep;
  return options;
}

/** Deals consecutive parts to processes, of which some may get none. */
Processes Deal(const std::vector<PartMesh>& parts, std::size_t processes, unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<std::size_t> ends;
  for (std::size_t p = 0; p + 1 < processes; ++p)
  {
    ends.push_back(random() % (parts.size() + 1));
  }
  ends.push_back(parts.size());
  std::sort(ends.begin(), ends.end());
  Processes dealt;
  std::size_t begin = 0;
  for (const auto end : ends)
  {
    dealt.emplace_back(parts.begin() + static_cast<std::ptrdiff_t>(begin),
      parts.begin() + static_cast<std::ptrdiff_t>(end));
    begin = end;
  }
  return dealt;
}

/** Expects the bytes of one process from any number of them. */
void ExpectSameBytes(const PartMesh& mesh, std::uint8_t keep, int steps, bool withIds)
{
  const auto parts = Divide(mesh, 6, DealRandomly(mesh, 6, 5));
  const auto alone = GetPath("alone.gtn");
  const auto together = GetPath("together.gtn");
  auto options = MakeProcessOptions(keep);
  WriteParts(alone, parts, options, steps, withIds);
  const auto expected = ReadBytes(alone);
  std::filesystem::remove(alone);
  for (std::size_t processes = 1; processes <= 5; ++processes)
  {
    SCOPED_TRACE(std::to_string(processes) + " processes");
    options.SpillMemory = processes % 2 == 0 ? 0 : 1 << 20;
    const auto dealt = Deal(parts, processes, static_cast<unsigned>(7 * processes + 1));
    for (const auto& error : WriteTogether(together, dealt, options, steps, withIds))
    {
      EXPECT_EQ(error, "");
    }
    EXPECT_TRUE(ReadBytes(together) == expected);
    EXPECT_EQ(ListFolder(together), (std::vector<std::string>{ "together.gtn" }));
    std::filesystem::remove(together);
  }
}

PartMesh MakeTets()
{
  auto cubes = MakeCubes(6, 0.2);
  cubes.Coordinates.insert(cubes.Coordinates.end(), { 50, 0, 0, 51, 0, 0 }); // unused
  return MakePartMesh(cubes);
}
}

TEST(PartProcesses, TetrahedraAreThoseOfOneProcess)
{
  const auto mesh = MakeTets();
  ExpectSameBytes(mesh, KeepNone, 1, false);
  ExpectSameBytes(mesh, KeepNone, 0, true);
}

TEST(PartProcesses, CellsOfAllTypesAreThoseOfOneProcess)
{
  ExpectSameBytes(MakePartMesh(Mixture(5)), KeepNone, 1, false);
}

TEST(PartProcesses, TimeStepsAreThoseOfOneProcess)
{
  ExpectSameBytes(MakeTets(), KeepNone, 5, false);
}

TEST(PartProcesses, OriginalNumbersAreThoseOfOneProcess)
{
  ExpectSameBytes(MakeTets(), KeepAll, 2, false);
  ExpectSameBytes(MakePartMesh(Mixture(5)), KeepAll, 1, true);
}

TEST(PartProcesses, UnusedPointsOfAllProcessesAreWritten)
{
  const auto mesh = MakeTets();
  auto parts = Divide(mesh, 4, DealSlabs(mesh, 4, 6));
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    parts[p].Cells.Coordinates.insert(
      parts[p].Cells.Coordinates.end(), { 60 + static_cast<double>(p), 0, 0, 70, 0, 0 });
    parts[p].PointIds.insert(parts[p].PointIds.end(), { 90000 + static_cast<int>(p), 99999 });
  }
  for (const std::uint8_t keep : { KeepNone, KeepAll })
  {
    WriteParts(GetPath("alone.gtn"), parts, MakeProcessOptions(keep), 3);
    const auto errors = WriteTogether(GetPath("together.gtn"),
      { { parts[0] }, { parts[1] }, {}, { parts[2], parts[3] }, {} }, MakeProcessOptions(keep), 3,
      false);
    EXPECT_EQ(errors, std::vector<std::string>(5));
    EXPECT_TRUE(ReadBytes(GetPath("together.gtn")) == ReadBytes(GetPath("alone.gtn")));
  }
}

TEST(PartProcesses, AnErrorOfOneIsThatOfAll)
{
  const auto mesh = MakeTets();
  const auto parts = Divide(mesh, 3, DealSlabs(mesh, 3, 6));
  const auto path = GetPath("together.gtn");
  PutFile("together.gtn", { 1, 2, 3 });
  const auto expectErrors =
    [&](const Processes& processes, const Fault& fault, const std::string& what)
  {
    for (const auto& error :
      WriteTogether(path, processes, MakeProcessOptions(KeepNone), 2, false, fault))
    {
      EXPECT_NE(error.find(what), std::string::npos) << error;
    }
    EXPECT_EQ(ReadBytes(path), "\1\2\3");
    EXPECT_EQ(ListFolder(path), (std::vector<std::string>{ "together.gtn" }));
  };
  const Processes processes{ { parts[0] }, { parts[1] }, { parts[2] } };
  for (const std::size_t process : { 0, 1, 2 })
  {
    expectErrors(processes, { process, true, 0 }, "out of luck");
    expectErrors(processes, { process, false, 0 }, "out of luck");
    expectErrors(processes, { process, true, 1 }, "different numbers of time steps");
  }
  expectErrors({ {}, {}, {} }, {}, "no process has a part");
}

TEST(PartProcesses, AFolderThatIsMissingIsAnErrorOfAll)
{
  const auto parts = Divide(MakeTets(), 1, std::vector<std::size_t>(MakeTets().GetCells(), 0));
  for (const auto& error : WriteTogether(GetPath("missing") + "/together.gtn", { parts, {}, {} },
         MakeProcessOptions(KeepNone), 1, false))
  {
    EXPECT_NE(error.find("missing"), std::string::npos) << error;
  }
}
