// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnHelp_h
#define gtnHelp_h

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace gtn
{
/** The group of the options that all subcommands have. */
extern const char* const CommonGroup;

/** The name of the argument that takes the input files and the output behind them. */
extern const char* const FilesArgument;

/** "-q, --quiet", or the name of an argument. */
std::string TitleOf(const CLI::Option& option, bool positional);

/** A text up to the end of its first sentence. */
std::string FirstSentence(const std::string& text);

/** The first sentence of the description. */
std::string SummaryOf(const CLI::App& command);

/** The commands directly below a program or a command. */
std::vector<const CLI::App*> CommandsOf(const CLI::App& app);

/** Lays out what --help prints. */
class HelpFormatter : public CLI::Formatter
{
public:
  HelpFormatter();

  std::string make_option_name(const CLI::Option* option, bool positional) const override;
  std::string make_option_opts(const CLI::Option* option) const override;
  std::string make_option_desc(const CLI::Option* option) const override;
  std::string make_option_usage(const CLI::Option* option) const override;
  std::string make_subcommand(const CLI::App* command) const override;
  std::string make_footer(const CLI::App* app) const override;
};
}

#endif
