# SPDX-License-Identifier: MIT
# Sets the time of all packaged files to SOURCE_DATE_EPOCH, so that builds are reproducible.
if(DEFINED ENV{SOURCE_DATE_EPOCH})
    execute_process(COMMAND find "${CPACK_TEMPORARY_DIRECTORY}" -exec touch -h -d "@$ENV{SOURCE_DATE_EPOCH}" {} + COMMAND_ERROR_IS_FATAL ANY)
endif()
