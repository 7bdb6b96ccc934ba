"""scenes: what comes with the package."""

from __future__ import annotations

import click

from graphic_tmm.commands.shared.spoken import Command


@click.command(cls=Command)
def scenes() -> None:
    """List the scenes that come with the package."""
    import tomllib

    from graphic_tmm.scene.packaged import packaged

    found = packaged()
    width = max((len(path.name) for path in found), default=0)
    for path in found:
        title = tomllib.loads((path / "scene.toml").read_text(encoding="utf-8")).get("title", "")
        click.echo(f"{path.name:<{width}}  {title}")
