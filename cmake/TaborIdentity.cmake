# SPDX-License-Identifier: MIT
# Who makes Tabor, where to reach them, and where the sources are: filled in once, by a maintainer. Packages, the
# desktop entry, the plugins, CITATION.cff and codemeta.json of a release take them from here; tools/release says what is still empty.

set(TABOR_IDENTITY_NAME "The Tabor authors")
set(TABOR_IDENTITY_ADDRESS "") # of mail
set(TABOR_IDENTITY_REPOSITORY "") # address of the sources, "https://..."
set(TABOR_IDENTITY_ID "tabor") # of the application on desktops: a reverse domain name that is yours, "org.example.Tabor"
