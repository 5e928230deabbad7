"""Licences as `ros2 pkg create` and ament_copyright know them: SPDX names, and the text of a file's header."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

_BSD_FIRST = (
    "Redistribution and use in source and binary forms, with or without modification, are permitted provided"
)
_BSD_SOURCE = "Redistributions of source code must retain the above copyright notice"
_BSD_BINARY = "Redistributions in binary form must reproduce the above copyright notice"
_BSD_THIRD = (
    "may be used to endorse or promote products derived from this software without specific prior written"
)
_BSD_LAST = "THIS SOFTWARE IS PROVIDED BY THE COPYRIGHT HOLDERS AND CONTRIBUTORS"
_MIT_FIRST = (
    "Permission is hereby granted, free of charge, to any person obtaining a copy of this software and associated "
    'documentation files (the "Software"), to deal in the Software without restriction'
)
_MIT_NOTICE = "The above copyright notice and this permission notice shall be included in all copies"
_AS_IS = 'THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND'


class License(NamedTuple):
    """A licence: how a header that grants it is recognised."""

    name: str
    """ament_copyright's."""
    spdx: str
    phrases: tuple[str, ...]
    """What the header has, in this order, single spaces between the words."""


LICENSES = (
    License(
        "apache2",
        "Apache-2.0",
        (
            'Licensed under the Apache License, Version 2.0 (the "License");',
            "you may not use this file except in compliance with the License.",
            "See the License for the specific language governing permissions and limitations under the License.",
        ),
    ),
    License(
        "boost1",
        "BSL-1.0",
        ("Boost Software License", "Version 1.0"),
    ),
    License("bsd_3clause", "BSD-3-Clause", (_BSD_FIRST, _BSD_SOURCE, _BSD_BINARY, _BSD_THIRD, _BSD_LAST)),
    License("bsd_2clause", "BSD-2-Clause", (_BSD_FIRST, _BSD_SOURCE, _BSD_BINARY, _BSD_LAST)),
    License("mit", "MIT", (_MIT_FIRST, _MIT_NOTICE, _AS_IS)),
    License("mit0", "MIT-0", (_MIT_FIRST, _AS_IS)),
    License(
        "lgplv3",
        "LGPL-3.0-only",
        (
            "under the terms of the GNU Lesser General Public License as published by the Free Software Foundation",
        ),
    ),
    License(
        "gplv3",
        "GPL-3.0-only",
        ("under the terms of the GNU General Public License as published by the Free Software Foundation",),
    ),
)
"""The licences, the more specific ones first."""


def find_license_text(spdx: str) -> str | None:
    """Return the text of a licence by its SPDX name, or None for one that isn't known."""
    if not any(licence.spdx == spdx for licence in LICENSES):
        return None
    return (Path(__file__).parent / "license_texts" / f"{spdx}.txt").read_text("utf-8")


def find_license(text: str) -> str | None:
    """Return the name of the licence that the text of a header grants, or None.

    Args:
        text: Without the signs of comments; line breaks and multiple spaces count as one space.
    """
    words = " ".join(text.split())
    for licence in LICENSES:
        at = 0
        for phrase in licence.phrases:
            at = words.find(phrase, at)
            if at < 0:
                break
        else:
            return licence.name
    return None
