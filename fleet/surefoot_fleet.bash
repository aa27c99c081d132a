# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
_surefoot_fleet() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}
  if [ "$COMP_CWORD" -eq 1 ]; then
    mapfile -t COMPREPLY < <(compgen -f -X '!*.y*ml' -- "$word"; compgen -d -- "$word")
  elif [ "$before" = --profile ]; then
    mapfile -t COMPREPLY < <(compgen -W slurm -- "$word")
  else
    mapfile -t COMPREPLY < <(compgen -W "--profile --cores --jobs --dry-run --default-resources" -- "$word")
  fi
}
complete -o filenames -F _surefoot_fleet surefoot_fleet
