// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnAddress_h
#define gtnAddress_h

namespace gtn
{
/** What people need to know about it. */
inline constexpr const char* AddressHelp = "A .gtn or .ghv file to read may be on a web server: "
                                           "https://example.org/mesh.gtn. Only the parts\n"
                                           "that are needed are fetched, by libcurl. The "
                                           "environment variable GTN_TIMEOUT has the seconds to\n"
                                           "wait for a server (default: 60).";

/** Lets all readers of Gatun open addresses of web servers in place of names of files. Those that
 * open the same address share what is fetched. */
void OpenAddresses();
}

#endif
