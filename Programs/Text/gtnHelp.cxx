// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnHelp.h"

#include <sstream>

namespace gtn
{
const char* const CommonGroup = "Common options";
const char* const FilesArgument = "FILES";

namespace
{

// Breaks lines at spaces; all but the first are indented.
std::string Wrapped(const std::string& text, std::size_t indent, std::size_t width)
{
  std::istringstream words(text);
  std::string wrapped;
  std::size_t length = 0;
  for (std::string word; words >> word;)
  {
    if (length > 0 && length + 1 + word.size() > width)
    {
      wrapped += '\n' + std::string(indent, ' ');
      length = 0;
    }
    wrapped += (length > 0 ? " " : "") + word;
    length += (length > 0 ? 1 : 0) + word.size();
  }
  return wrapped;
}

} // anonymous namespace

//------------------------------------------------------------------------------
std::string TitleOf(const CLI::Option& option, bool positional)
{
  if (positional)
  {
    return option.get_name(true) == FilesArgument ? "IN... OUT" : option.get_name(true);
  }
  std::string title;
  for (const char c : option.get_name(false, true))
  {
    if (c == '{') // the value that a flag stands for
    {
      break;
    }
    title += c;
    title += c == ',' ? " " : "";
  }
  return title;
}

//------------------------------------------------------------------------------
std::string FirstSentence(const std::string& text)
{
  for (std::size_t i = 0; i + 1 < text.size(); ++i)
  {
    if (text[i] == '.' && (text[i + 1] == ' ' || text[i + 1] == '\n'))
    {
      return text.substr(0, i + 1);
    }
  }
  return text;
}

//------------------------------------------------------------------------------
std::string SummaryOf(const CLI::App& command)
{
  return FirstSentence(command.get_description());
}

//------------------------------------------------------------------------------
std::vector<const CLI::App*> CommandsOf(const CLI::App& app)
{
  return app.get_subcommands([](const CLI::App*) { return true; });
}

namespace
{
// CLI11 2.6 fills the lines of descriptions and examples, which are lines already.
template <typename Formatter>
void KeepLines(Formatter& formatter)
{
  if constexpr (requires { formatter.enable_footer_formatting(false); })
  {
    formatter.enable_description_formatting(false);
    formatter.enable_footer_formatting(false);
  }
}
}

//------------------------------------------------------------------------------
HelpFormatter::HelpFormatter()
{
  this->column_width(26);
  KeepLines<CLI::Formatter>(*this);
}

//------------------------------------------------------------------------------
std::string HelpFormatter::make_option_name(const CLI::Option* option, bool positional) const
{
  return TitleOf(*option, positional);
}

//------------------------------------------------------------------------------
std::string HelpFormatter::make_option_opts(const CLI::Option* option) const
{
  const std::string& text = option->get_option_text();
  return text.empty() ? text : " " + text;
}

//------------------------------------------------------------------------------
std::string HelpFormatter::make_option_desc(const CLI::Option* option) const
{
  // CLI11 indents the lines.
  return Wrapped(option->get_description(), 0, 88 - this->get_column_width());
}

//------------------------------------------------------------------------------
std::string HelpFormatter::make_option_usage(const CLI::Option* option) const
{
  const std::string title = TitleOf(*option, true);
  const bool more = option->get_expected_max() > 1 && option->get_name(true) != FilesArgument;
  const std::string text = title + (more ? "..." : "");
  return option->get_required() ? text : "[" + text + "]";
}

//------------------------------------------------------------------------------
std::string HelpFormatter::make_subcommand(const CLI::App* command) const
{
  std::ostringstream out;
  const std::size_t column = 11;
  const std::string name = "  " + command->get_name();
  out << name << std::string(column - name.size(), ' ')
      << Wrapped(SummaryOf(*command), column, 88 - column) << "\n";
  return out.str();
}

//------------------------------------------------------------------------------
std::string HelpFormatter::make_footer(const CLI::App* app) const
{
  const std::string footer = app->get_footer();
  return footer.empty() ? footer : "\n" + footer + "\n";
}
}
