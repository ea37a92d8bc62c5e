// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunFastSteps.h"

#include "gatunBoundedSteps.h"
#include "gatunError.h"
#include "gatunGatePredictor.h"
#include "gatunGateRule.h"
#include "gatunGuess.h"
#include "gatunNumberStream.h"

#include <algorithm>
#include <bit>
#include <cstddef>

namespace gatun
{
namespace
{
/** Numbers that stand for steps, 1 and more, are less than 2^this. */
constexpr unsigned StepBits =
  std::bit_width(2 * static_cast<std::uint64_t>(BoundedSteps<Domain>::End));

/** Collects values as steps from their predictions. Values that have none are special: 0, and the
 * bits that differ from the special value before. */
template <typename AnyDomain>
class StepWriter
{
public:
  StepWriter(const AnyDomain& domain, const Quantizer& rounding, bool onLattice)
    : Rule(domain, rounding, onLattice)
  {
  }

  /** Returns the key that readers will have. */
  Key Put(Key predicted, Key actual)
  {
    std::int64_t steps = 0;
    Key key = actual;
    if (this->Rule.FindSteps(this->Rule.FindOrigin({ predicted }), actual, steps, key))
    {
      this->Steps.Put(FromSigned(steps) + 1);
      return key;
    }
    this->Steps.Put(0);
    this->Special.Put(actual ^ this->Last);
    this->Last = actual;
    return actual;
  }

  void Finish(ByteWriter& out)
  {
    this->Steps.Finish(out);
    this->Special.Finish(out);
  }

private:
  const BoundedSteps<AnyDomain> Rule;
  NumberWriter Steps;
  NumberWriter Special;
  Key Last = 0;
};

/** Reads what StepWriter collected. */
template <typename AnyDomain>
class StepReader
{
public:
  StepReader(ByteReader& in, std::size_t count, const AnyDomain& domain, const Quantizer& rounding,
    bool onLattice)
    : Rule(domain, rounding, onLattice)
    , Steps(in, count, StepBits)
    , Special(in,
        static_cast<std::size_t>(
          std::count(this->Steps.GetLengths(), this->Steps.GetLengths() + count, 0)),
        domain.GetBits())
  {
  }

  Key Get(Key predicted)
  {
    const auto number = this->Steps.Get();
    if (number == 0)
    {
      this->Last ^= this->Special.Get();
      return this->Last;
    }
    return this->Rule.GetKey(this->Rule.FindOrigin({ predicted }), ToSigned(number - 1));
  }

private:
  const BoundedSteps<AnyDomain> Rule;
  NumberReader Steps;
  NumberReader Special;
  Key Last = 0;
};

/** Calls code(values, domain) with a class for predictions and one for the plain keys. */
template <typename Code>
void WithRoundedValues(const Domain& domain, Code&& code)
{
  if (Float32Domain::Matches(domain))
  {
    code(SingleValues(), Float32Domain());
  }
  else
  {
    code(DoubleValues(domain), domain);
  }
}

/** Whether a component goes on as one without a bound. */
bool PutExactness(ByteWriter& out, const Domain& domain, std::span<const Key> keys)
{
  const bool isExact = AreStepsTooFine(domain, keys);
  out.Put<std::uint8_t>(isExact ? 1 : 0);
  return isExact;
}

bool GetExactness(ByteReader& in)
{
  const auto isExact = in.Get<std::uint8_t>();
  if (isExact > 1)
  {
    ThrowCorrupt("an array's stream has unknown flags");
  }
  return isExact != 0;
}

}

//------------------------------------------------------------------------------
void PutVertexSteps(
  ByteWriter& out, const Domain& domain, const GateVertices& vertices, const GateKeys& keys)
{
  if (PutExactness(out, domain, keys.Now))
  {
    PutVertexValues(out, domain, vertices, keys);
    return;
  }
  VertexRule rule = ChooseVertexRule(domain, vertices, keys);
  rule.Copies = false;
  rule.Write(out);
  WithRoundedValues(domain,
    [&](const auto& values, const auto& plain)
    {
      VertexPredictor predictor(values, vertices, keys, rule.Weights);
      StepWriter steps(plain, domain.GetQuantizer(), domain.GetQuantizer().OnLattice);
      for (const auto v : FindOwn(vertices.Sources))
      {
        predictor.Set(v, steps.Put(predictor.Predict(v), keys.Now[v]));
      }
      steps.Finish(out);
    });
}

//------------------------------------------------------------------------------
void GetVertexSteps(
  ByteReader& in, const Domain& domain, const GateVertices& vertices, const GateKeys& keys)
{
  if (GetExactness(in))
  {
    GetVertexValues(in, domain, vertices, keys);
    return;
  }
  const auto rule = VertexRule::Read(in);
  if (rule.Copies)
  {
    ThrowCorrupt("an array's stream has copies of rounded values");
  }
  WithRoundedValues(domain,
    [&](const auto& values, const auto& plain)
    {
      VertexPredictor predictor(values, vertices, keys, rule.Weights);
      const auto own = FindOwn(vertices.Sources);
      StepReader steps(
        in, own.size(), plain, domain.GetQuantizer(), domain.GetQuantizer().OnLattice);
      for (const auto v : own)
      {
        predictor.Set(v, steps.Get(predictor.Predict(v)));
      }
    });
}

//------------------------------------------------------------------------------
void PutItemSteps(ByteWriter& out, const Domain& domain, std::span<const std::uint32_t> parents,
  bool onLattice, const GateKeys& keys)
{
  if (PutExactness(out, domain, keys.Now))
  {
    PutItemValues(out, domain, parents, keys);
    return;
  }
  WithRoundedValues(domain,
    [&](const auto& values, const auto& plain)
    {
      const ItemPredictor predictor(values, parents, keys);
      StepWriter steps(plain, domain.GetQuantizer(), onLattice || domain.GetQuantizer().OnLattice);
      for (std::size_t i = 0; i < keys.Now.size(); ++i)
      {
        keys.Now[i] = steps.Put(predictor.Predict(i), keys.Now[i]);
      }
      steps.Finish(out);
    });
}

//------------------------------------------------------------------------------
void GetItemSteps(ByteReader& in, const Domain& domain, std::span<const std::uint32_t> parents,
  bool onLattice, const GateKeys& keys)
{
  if (GetExactness(in))
  {
    GetItemValues(in, domain, parents, keys);
    return;
  }
  WithRoundedValues(domain,
    [&](const auto& values, const auto& plain)
    {
      const ItemPredictor predictor(values, parents, keys);
      StepReader steps(in, keys.Now.size(), plain, domain.GetQuantizer(),
        onLattice || domain.GetQuantizer().OnLattice);
      for (std::size_t i = 0; i < keys.Now.size(); ++i)
      {
        keys.Now[i] = steps.Get(predictor.Predict(i));
      }
    });
}
}
