# {{title}}: made by Chiaro {{version}}. The folder as an extension of Blender.

from .{{stem}} import register, unregister

__all__ = ["register", "unregister"]
