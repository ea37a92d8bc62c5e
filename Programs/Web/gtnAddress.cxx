// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnAddress.h"

#include "gtnText.h"
#include "gtnWebSource.h"

#include "gatunByteSource.h"

#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace gtn
{
namespace
{
std::shared_ptr<const gatun::ByteSource> OpenAddress(const std::string& name)
{
  if (!IsAddress(name))
  {
    return nullptr;
  }
  static std::mutex guard;
  static std::map<std::string, std::shared_ptr<const WebSource>> opened;
  const std::lock_guard<std::mutex> lock(guard);
  auto& source = opened[name];
  if (!source)
  {
    source = std::make_shared<const WebSource>(name);
  }
  return source;
}
}

//------------------------------------------------------------------------------
void OpenAddresses()
{
  gatun::SetSourceOpener(&OpenAddress);
}
}
