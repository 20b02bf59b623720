# SPDX-License-Identifier: MIT
# Removes debug information and compiler notes from FILE, which Debian packages must not contain.
execute_process(COMMAND strip --strip-debug --remove-section=.comment --remove-section=.note
                        --enable-deterministic-archives "${FILE}" COMMAND_ERROR_IS_FATAL ANY)
