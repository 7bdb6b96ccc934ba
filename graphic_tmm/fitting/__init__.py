"""How large things are drawn: scale factors, what sheets hold, what helps where they do not."""
