// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// gtn --completion: completion of command lines in bash and zsh, from the definitions of commands
// and options.

#include "gtnCommands.h"
#include "gtnFailure.h"
#include "gtnHelp.h"
#include "gtnText.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>
#include <vector>

namespace gtn
{
namespace
{

/** What the value of an option may be. */
struct Value
{
  bool IsTaken = false; ///< whether there is one at all
  std::vector<std::string> Words;
  bool Files = false;
  bool Folders = false;
};

std::vector<std::string> SplitAt(std::string_view text, char separator)
{
  std::vector<std::string> parts(1);
  for (const char c : text)
  {
    if (c == separator)
    {
      parts.emplace_back();
    }
    else
    {
      parts.back() += c;
    }
  }
  return parts;
}

bool IsWord(const std::string& text)
{
  return !text.empty() &&
    std::all_of(text.begin(), text.end(), [](char c) { return std::islower(c) || c == '-'; });
}

/** From the check of an option, "{none,points}", and from its text, "N|whole [8]". */
Value ValueOf(const CLI::Option& option)
{
  Value value;
  value.IsTaken = option.get_items_expected_max() > 0;
  const std::string checks = option.get_type_name();
  const std::size_t begin = checks.find('{');
  const std::size_t end = checks.find('}');
  if (value.IsTaken && begin < end && end != checks.npos)
  {
    value.Words = SplitAt(checks.substr(begin + 1, end - begin - 1), ',');
  }
  const std::string& text = option.get_option_text();
  for (const std::string& part : SplitAt(text.substr(0, text.find(' ')), '|'))
  {
    if (IsWord(part))
    {
      value.Words.push_back(part);
    }
    value.Files = value.Files || part == "FILE";
    value.Folders = value.Folders || part == "DIR" || part == "FOLDER";
  }
  return value;
}

/** "-q" and "--quiet". */
std::vector<std::string> NamesOf(const CLI::Option& option)
{
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames())
  {
    names.push_back("-" + name);
  }
  for (const std::string& name : option.get_lnames())
  {
    names.push_back("--" + name);
  }
  return names;
}

std::vector<const CLI::Option*> OptionsOf(const CLI::App& app)
{
  return app.get_options([](const CLI::Option* option)
    { return !option->get_positional() && !option->get_group().empty(); });
}

bool TakesFiles(const CLI::App& app)
{
  return !app.get_options([](const CLI::Option* option) { return option->get_positional(); })
            .empty();
}

// What depends on the command, for bash. A path is "/volume/pack".
struct BashCases
{
  std::vector<std::string> Paths;
  std::string Values;   ///< by path and option
  std::string Commands; ///< by path
};

void AddBashCases(const CLI::App& app, const std::string& path, BashCases& cases)
{
  std::vector<std::string> all;
  std::vector<std::string> free;
  for (const CLI::Option* option : OptionsOf(app))
  {
    const std::vector<std::string> names = NamesOf(*option);
    all.insert(all.end(), names.begin(), names.end());
    const Value value = ValueOf(*option);
    for (const std::string& name : names)
    {
      const std::string key = path + ":" + name;
      if (value.IsTaken && value.Words.empty() && !value.Files && !value.Folders)
      {
        free.push_back(key);
      }
      else if (value.IsTaken)
      {
        cases.Values += fmt::format("    {}) words='{}' rest={} ;;\n", key, Join(value.Words, " "),
          value.Files       ? "files"
            : value.Folders ? "folders"
                            : "none");
      }
    }
  }
  if (!free.empty())
  {
    cases.Values += fmt::format("    {}) rest=none ;;\n", Join(free, " | "));
  }

  std::vector<std::string> commands;
  for (const CLI::App* command : CommandsOf(app))
  {
    commands.push_back(command->get_name());
  }
  cases.Commands +=
    fmt::format("    {}) options='{}' words='{}' rest={} ;;\n", path.empty() ? "''" : path,
      Join(all, " "), Join(commands, " "), TakesFiles(app) ? "files" : "none");
  for (const CLI::App* command : CommandsOf(app))
  {
    cases.Paths.push_back(path + "/" + command->get_name());
    AddBashCases(*command, cases.Paths.back(), cases);
  }
}

void PrintBash(const CLI::App& app)
{
  BashCases cases;
  AddBashCases(app, "", cases);
  fmt::print(R"(# Completion of gtn in bash, written by gtn --completion bash.
_gtn()
{{
  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}} path= i
  # --option=value is three words.
  if [[ $word == = ]]; then
    word=
  elif [[ $before == = ]]; then
    before=${{COMP_WORDS[COMP_CWORD - 2]}}
  fi
  for ((i = 1; i < COMP_CWORD; ++i)); do
    case $path/${{COMP_WORDS[i]}} in
      {}) path+=/${{COMP_WORDS[i]}} ;;
    esac
  done
  local options= words= rest=
  case $path in
{}  esac
  case $path:$before in
{}    *) [[ $word != -* ]] || words=$options ;;
  esac
  # Without a match, bash completes names of files itself.
  case $rest in
    folders) compopt +o default -o dirnames ;;
    none) compopt +o default ;;
  esac
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
}}
complete -o default -F _gtn gtn
)",
    Join(cases.Paths, " | "), cases.Commands, cases.Values);
}

// Text in single quotes, in which zsh's _arguments sees no syntax.
std::string ZshText(const std::string& text)
{
  std::string quoted;
  for (const char c : text)
  {
    const bool hasMeaning = c == '[' || c == ']' || c == ':' || c == '\\';
    quoted += c == '\'' ? "'\\''" : (hasMeaning ? "\\" : "") + std::string(1, c);
  }
  return quoted;
}

// What follows the name of an option.
std::string ZshValue(const CLI::Option& option)
{
  const Value value = ValueOf(option);
  if (!value.IsTaken)
  {
    return {};
  }
  std::string action = value.Words.empty() ? "" : "(" + Join(value.Words, " ") + ")";
  if (value.Files && !value.Words.empty())
  {
    action = fmt::format("_alternative \"words\\:value\\:{}\" \"files\\:file\\:_files\"", action);
  }
  else if (value.Files || value.Folders)
  {
    action = value.Files ? "_files" : "_files -/";
  }
  const std::string& text = option.get_option_text();
  return fmt::format(":{}:{}", ZshText(text.empty() ? "value" : text), action);
}

std::string ZshOptions(const CLI::App& app)
{
  std::string specifications;
  for (const CLI::Option* option : OptionsOf(app))
  {
    const std::vector<std::string> names = NamesOf(*option);
    const bool repeats = option->get_items_expected_max() > 1;
    for (const std::string& name : names)
    {
      const bool isLong = name.size() > 2;
      const bool takes = ValueOf(*option).IsTaken;
      specifications += fmt::format("    '{}{}{}[{}]{}' \\\n",
        repeats ? "*" : "(" + Join(names, " ") + ")", name, takes ? (isLong ? "=" : "+") : "",
        ZshText(FirstSentence(option->get_description())), ZshValue(*option));
    }
  }
  return specifications;
}

void PrintZsh(const CLI::App& app, const std::string& function)
{
  std::string commands;
  std::string calls;
  for (const CLI::App* command : CommandsOf(app))
  {
    const std::string& name = command->get_name();
    commands += fmt::format("        '{}:{}'\n", name, ZshText(SummaryOf(*command)));
    calls += fmt::format("        {}) {}_{} ;;\n", name, function, name);
    PrintZsh(*command, function + "_" + name);
  }
  if (commands.empty())
  {
    fmt::print(
      "{}()\n{{\n  _arguments -s \\\n{}    '*:file:_files'\n}}\n\n", function, ZshOptions(app));
    return;
  }
  fmt::print(R"({}()
{{
  local curcontext=$curcontext state line
  typeset -A opt_args
  _arguments -C \
{}    '1:command:->command' \
    '*::argument:->argument'
  case $state in
    command)
      local -a commands=(
{}      )
      _describe command commands
      ;;
    argument)
      case $words[1] in
{}      esac
      ;;
  esac
}}

)",
    function, ZshOptions(app), commands, calls);
}

} // anonymous namespace

//------------------------------------------------------------------------------
void PrintCompletion(const CLI::App& app, const std::string& shell)
{
  if (shell == "bash")
  {
    PrintBash(app);
  }
  else if (shell == "zsh")
  {
    fmt::print("#compdef gtn\n# Completion of gtn in zsh, written by gtn --completion zsh.\n\n");
    PrintZsh(app, "_gtn");
    fmt::print("_gtn \"$@\"\n");
  }
  else
  {
    throw UsageError("--completion: bash or zsh, not " + MakePrintableLine(shell));
  }
}
}
