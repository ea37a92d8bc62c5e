// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnAddress_h
#define gtnAddress_h

namespace gtn
{
/** Lets all readers of Gatun open addresses of web servers in place of names of files. Those that
 * open the same address share what is fetched. */
void OpenAddresses();
}

#endif
