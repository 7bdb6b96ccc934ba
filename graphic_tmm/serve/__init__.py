"""A scene in a browser that follows its file: served from this computer, drawn again at every edit."""
