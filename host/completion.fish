# SPDX-License-Identifier: MIT
# Completion of the command line of tabor in fish. What there is to complete, the program says itself.

function __tabor_commands
    tabor --help 2>/dev/null | string replace -rf '^  ([a-z][a-z-]*) +(.*)' '$1\t$2'
end

# Options of the command that the line has.
function __tabor_options
    set -l words (commandline -opc)
    tabor $words[2] --help 2>/dev/null | string replace -rf '^ +(-[a-zA-Z], )?(--[a-z0-9-]+)( [A-Z=]+)? +(.*)' '$2\t$4'
end

function __tabor_presets
    tabor presets $argv 2>/dev/null | string replace -r ' .*' ''
end

# The words that the help lists for the value of the option before: "draft, live, studio or reference".
function __tabor_values
    set -l words (commandline -opc)
    set -l text (tabor $words[2] --help 2>/dev/null | string match -rg -- "^ +(?:-[a-zA-Z], )?$words[-1] ([A-Z=]+ .*)")
    string match -q 'KIT*' -- $text; and __tabor_presets --kits
    string match -rg '^[A-Z]+ +(?:of )?((?:[a-z0-9-]+, )*[a-z0-9-]+ (?:or|and) [a-z0-9-]+)(?:[ ,]|$)' -- $text |
        string replace -ra ', | or | and ' '\n'
end

complete -c tabor -n __fish_use_subcommand -f -a '(__tabor_commands)'
complete -c tabor -n 'not __fish_use_subcommand; and string match -q -- "-*" (commandline -ct)' -a '(__tabor_options)'
complete -c tabor -n 'not __fish_use_subcommand; and string match -q -- "-*" (commandline -opc)[-1]' -a '(__tabor_values)'
complete -c tabor -n 'not __fish_use_subcommand' -a '(__tabor_presets)'
