"""A student who is not the package: draws by numpy and plane geometry, and makes mistakes of his own."""
